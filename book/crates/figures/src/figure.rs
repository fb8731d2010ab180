//! A figure: what it shows, what the reader can set, and what it reads out.

use crate::{Drawing, Handle, Mark, Parameter, ParameterId, ParameterValues};
use glam::DVec2;
use image::RgbImage;
use std::collections::BTreeMap;

/// A drawing or a picture that a reader can change on a page.
#[derive(Debug)]
pub struct Figure {
    /// The name in chapters and requests.
    pub name: &'static str,
    /// What the figure shows.
    pub content: Content,
    /// The figure whose values this one takes instead of having controls of its own.
    pub follows: Option<&'static str>,
    /// The numbers that the reader can set.
    pub parameters: Vec<Parameter>,
    /// The marks that the reader can drag.
    pub handles: Vec<Handle>,
    /// Writes the texts elsewhere on the page that depend on the values.
    pub readouts: fn(&ParameterValues) -> Readouts,
    /// The number of rows in the table of a pixel's trace, 0 if there is none. [`row_readout_name`]
    /// returns the name of a row's readout.
    pub row_count: usize,
    /// Extras for a scene that the reader edits. None for all other figures.
    pub editable_scene: Option<EditableScene>,
    /// Whether there is anything to show at these values.
    pub has_something_to_show: fn(&ParameterValues) -> bool,
}

/// What a figure shows at given values.
#[derive(Debug)]
pub enum Content {
    /// Lines and labels.
    Drawing {
        /// The title, for readers who can't see the drawing.
        title: &'static str,
        /// The caption, in Markdown with formulas.
        caption: &'static str,
        /// Draws the lines and labels at these values.
        draw: fn(&ParameterValues) -> Drawing,
    },
    /// Pixels. The description and the caption are in the chapter.
    Picture {
        /// Draws the pixels at these values, with at most this many columns.
        draw: fn(&ParameterValues, u32) -> RgbImage,
    },
}

/// Texts, keyed by name: numbers and vectors, formatted for the page, and some phrases.
pub type Readouts = BTreeMap<String, String>;

/// The name of a readout in a row of a table, such as a3 for the column a and the row 3. Rows count
/// from 0.
pub fn row_readout_name(column: &str, row: usize) -> String {
    format!("{column}{row}")
}

/// Makes readouts from pairs of a name and a text.
pub fn collect_readouts<const N: usize>(texts: [(&str, String); N]) -> Readouts {
    let mut readouts = Readouts::new();
    readouts.extend(texts.map(|(name, text)| (name.to_owned(), text)));
    readouts
}

/// A scene in which the reader can set everything. Its parameters belong to objects, and the page
/// shows the controls of one object at a time.
#[derive(Debug)]
pub struct EditableScene {
    /// Formats the Rust program that draws the scene.
    pub program: fn(&ParameterValues) -> String,
    /// Finds the object at a position in the picture.
    pub object_at: fn(&ParameterValues, DVec2) -> Option<&'static str>,
    /// The objects that have a colour, with the parameters for its three channels.
    pub colour_parameters: Vec<(&'static str, [ParameterId; 3])>,
}

impl Content {
    /// Drops a drawing's title and caption in the modules, because the builder has already printed
    /// both. This function and [`Figure::new`] are inlined, so that the compiler leaves these strings
    /// out of the module.
    #[inline(always)]
    fn without_title_and_caption_in_modules(self) -> Self {
        match self {
            Self::Drawing { draw, .. } if cfg!(target_family = "wasm") => {
                Self::Drawing { title: "", caption: "", draw }
            }
            content => content,
        }
    }
}

impl Figure {
    /// A figure with this content and nothing else.
    #[inline(always)]
    pub(crate) fn new(name: &'static str, content: Content) -> Self {
        Self {
            name,
            content: content.without_title_and_caption_in_modules(),
            follows: None,
            parameters: vec![],
            handles: vec![],
            readouts: |_| Readouts::new(),
            row_count: 0,
            editable_scene: None,
            has_something_to_show: |_| true,
        }
    }

    /// The default value of each parameter, as in the printed book.
    pub fn default_values(&self) -> ParameterValues {
        self.parameters.iter().map(|parameter| (parameter.id, parameter.default)).collect()
    }

    /// The handle that is a probe, if there is one.
    pub fn probe(&self) -> Option<&Handle> {
        self.handles.iter().find(|handle| handle.mark == Mark::Probe)
    }

    /// Returns the default values, but with the probe at the pixel (i, j). Returns None if there is
    /// no probe, or no such pixel.
    pub fn values_at_pixel(&self, [i, j]: [f64; 2]) -> Option<ParameterValues> {
        let probe = self.probe()?;
        let mut values = self.default_values();
        values.set(probe.horizontal, i);
        values.set(probe.vertical, j);
        let allowed = self.nearest_allowed_values(&values)?;
        (allowed == values).then_some(values)
    }

    /// Returns the values after a handle is dragged to a position, or None if the figure has nothing
    /// to show at these values.
    pub fn drag_handle(
        &self,
        values: &ParameterValues,
        handle: &Handle,
        position: DVec2,
    ) -> Option<ParameterValues> {
        let DVec2 { x, y } = (handle.coordinates_at)(values, position)?;
        let mut new = values.clone();
        new.set(handle.horizontal, x);
        new.set(handle.vertical, y);
        self.nearest_allowed_values(&new)
    }

    /// Replaces each value with the nearest one that its parameter allows. Returns None if a value
    /// isn't finite, or if the figure has nothing to show at the new values.
    pub fn nearest_allowed_values(&self, values: &ParameterValues) -> Option<ParameterValues> {
        let allowed = self
            .parameters
            .iter()
            .map(|parameter| (parameter.id, parameter.nearest_allowed(values[parameter.id])))
            .collect();
        (values.are_finite() && (self.has_something_to_show)(&allowed)).then_some(allowed)
    }
}

#[cfg(test)]
mod tests {
    use crate::find_figure;
    use crate::probe::{I, J};

    #[test]
    fn only_a_pixel_of_the_picture_can_be_probed() {
        let values = |name, pixel| find_figure(name).expect("a figure").values_at_pixel(pixel);
        let corner = values("step02_sphere", [639.0, 0.0]).expect("a pixel");
        assert_eq!((corner[I], corner[J]), (639.0, 0.0));
        for outside in [[640.0, 0.0], [0.0, -1.0], [0.5, 0.0], [f64::NAN, 0.0]] {
            assert_eq!(values("step02_sphere", outside), None, "{outside:?}");
        }
        assert_eq!(values("row", [0.0, 0.0]), None);
    }
}
