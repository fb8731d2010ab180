//! A figure: its content, what the reader can set, and its readouts.

use crate::{Drawing, Handle, Mark, Parameter, ParameterId, ParameterValues};
use glam::DVec2;
use image::RgbImage;
use std::collections::BTreeMap;

/// A drawing or a picture that a reader can change on a page.
#[derive(Debug)]
pub struct Figure {
    /// The figure's name, which chapters and requests use.
    pub name: &'static str,
    /// What the figure shows.
    pub content: Content,
    /// The name of the figure whose values this figure shows. None if this figure has values of its
    /// own.
    pub values_from: Option<&'static str>,
    /// The values that the reader can set.
    pub parameters: Vec<Parameter>,
    /// The handles, which the reader can drag.
    pub handles: Vec<Handle>,
    /// Formats the readouts for the given parameter values. Readouts are texts elsewhere on the
    /// page.
    pub readouts: fn(&ParameterValues) -> Readouts,
    /// The number of rows in the table that shows a pixel's trace, or 0 if there is no table.
    /// [`row_readout_name`] returns the name of each readout in a row.
    pub row_count: usize,
    /// The scene that the reader can edit. None if the figure has no such scene.
    pub editable_scene: Option<EditableScene>,
    /// Whether the figure has anything to show with the given parameter values.
    pub has_something_to_show: fn(&ParameterValues) -> bool,
}

/// What a figure shows, with the function that draws it.
#[derive(Debug)]
pub enum Content {
    /// Lines and labels.
    Drawing {
        /// The title, for readers who can't see the drawing.
        title: &'static str,
        /// The caption, in Markdown with formulas.
        caption: &'static str,
        /// Draws the lines and labels for the given parameter values.
        draw: fn(&ParameterValues) -> Drawing,
    },
    /// Pixels. The description and the caption are in the chapter.
    Picture {
        /// Draws the pixels for the given parameter values. The second argument is the maximum
        /// number of columns.
        draw: fn(&ParameterValues, u32) -> RgbImage,
    },
}

/// Texts that depend on a figure's values, keyed by name. Most are formatted numbers or vectors,
/// and some are phrases.
pub type Readouts = BTreeMap<String, String>;

/// The name of the readout in one cell of a table, such as `a3` in row 3 of the column `a`. Rows
/// are counted from 0.
pub fn row_readout_name(column: &str, row: usize) -> String {
    format!("{column}{row}")
}

/// Collects readouts from (name, text) pairs.
pub fn collect_readouts<const N: usize>(texts: [(&str, String); N]) -> Readouts {
    let mut readouts = Readouts::new();
    readouts.extend(texts.map(|(name, text)| (name.to_owned(), text)));
    readouts
}

/// A scene in which the reader can set everything. Every parameter of the figure belongs to an
/// object, and the lights and the camera count as objects, too. The page shows the controls of one
/// object at a time.
#[derive(Debug)]
pub struct EditableScene {
    /// Formats the Rust program that draws the scene.
    pub program: fn(&ParameterValues) -> String,
    /// Finds the object at a position in the picture.
    pub object_at: fn(&ParameterValues, DVec2) -> Option<&'static str>,
    /// Every object that has a colour, with the parameters for red, green and blue.
    pub colour_parameters_by_object: Vec<(&'static str, [ParameterId; 3])>,
}

impl Content {
    /// In WebAssembly, drops a drawing's title and caption, because the builder has already printed
    /// both. This function and [`Figure::new`] are inlined, so that the compiler leaves both
    /// strings out of the modules.
    #[inline(always)]
    fn without_title_and_caption_if_wasm(self) -> Self {
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
            content: content.without_title_and_caption_if_wasm(),
            values_from: None,
            parameters: vec![],
            handles: vec![],
            readouts: |_| Readouts::new(),
            row_count: 0,
            editable_scene: None,
            has_something_to_show: |_| true,
        }
    }

    /// The default value of each parameter.
    pub fn default_values(&self) -> ParameterValues {
        self.parameters.iter().map(|parameter| (parameter.id, parameter.default)).collect()
    }

    /// Draws the figure for the given parameter values, with labels that give way to the handles.
    /// Returns None if the figure is a picture.
    pub fn draw(&self, values: &ParameterValues) -> Option<Drawing> {
        let Content::Drawing { draw, .. } = self.content else { return None };
        let positions = self.handles.iter().filter_map(|handle| (handle.locate)(values));
        Some(draw(values).with_labels_clear_of_handles(positions.collect()))
    }

    /// The handle that is a probe, if the figure has a probe.
    pub fn probe(&self) -> Option<&Handle> {
        self.handles.iter().find(|handle| handle.mark == Mark::Probe)
    }

    /// Returns the default values, but with the probe at the pixel (i, j). Returns None if the
    /// figure has no probe, or the picture has no such pixel.
    pub fn default_values_with_probe_at(&self, [i, j]: [f64; 2]) -> Option<ParameterValues> {
        let probe = self.probe()?;
        let mut values = self.default_values();
        values.set(probe.horizontal, i);
        values.set(probe.vertical, j);
        let allowed_values = self.nearest_allowed_values(&values)?;
        (allowed_values == values).then_some(values)
    }

    /// Returns the values after a handle is dragged to a position. Returns None if the handle can't
    /// be dragged, or if the figure has nothing to show at the new values.
    pub fn values_after_drag(
        &self,
        values: &ParameterValues,
        handle: &Handle,
        position: DVec2,
    ) -> Option<ParameterValues> {
        let DVec2 { x, y } = (handle.coordinates_at)(values, position)?;
        let mut new_values = values.clone();
        new_values.set(handle.horizontal, x);
        new_values.set(handle.vertical, y);
        self.nearest_allowed_values(&new_values)
    }

    /// Replaces each value with the nearest value that its parameter allows. Returns None if a
    /// value isn't finite, or if the figure has nothing to show at the new values.
    pub fn nearest_allowed_values(&self, values: &ParameterValues) -> Option<ParameterValues> {
        let allowed_values = self
            .parameters
            .iter()
            .map(|parameter| (parameter.id, parameter.nearest_allowed(values[parameter.id])))
            .collect();
        (values.are_finite() && (self.has_something_to_show)(&allowed_values))
            .then_some(allowed_values)
    }
}

#[cfg(test)]
mod tests {
    use crate::find_figure;
    use crate::probe::{I, J};

    #[test]
    fn only_a_pixel_of_the_picture_can_be_probed() {
        let values = |name, pixel| {
            find_figure(name).expect("the figure exists").default_values_with_probe_at(pixel)
        };
        let corner = values("step02_sphere", [639.0, 0.0]).expect("the picture has this pixel");
        assert_eq!((corner[I], corner[J]), (639.0, 0.0));
        for outside in [[640.0, 0.0], [0.0, -1.0], [0.5, 0.0], [f64::NAN, 0.0]] {
            assert_eq!(values("step02_sphere", outside), None, "{outside:?}");
        }
        assert_eq!(values("row", [0.0, 0.0]), None);
    }
}
