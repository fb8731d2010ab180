//! A figure: its content, what the reader sets of it, and what it reads out.

use crate::{Drawing, Handle, Mark, Parameter, ParameterId, ParameterValues};
use glam::DVec2;
use image::RgbImage;
use std::collections::BTreeMap;

/// A drawing or a picture that a page can change.
pub struct Figure {
    /// The name in chapters and requests.
    pub name: &'static str,
    /// What is shown.
    pub content: Content,
    /// The figure whose values this one takes, instead of having controls.
    pub followed: Option<&'static str>,
    /// The numbers that the reader sets.
    pub parameters: Vec<Parameter>,
    /// The marks that the reader drags.
    pub handles: Vec<Handle>,
    /// The texts elsewhere on the page that depend on these values.
    pub readouts: fn(&ParameterValues) -> Readouts,
    /// What only a scene of the reader's own has.
    pub editable_scene: Option<EditableScene>,
    /// Whether there is something to show at these values.
    pub is_allowed: fn(&ParameterValues) -> bool,
}

/// What a figure shows at given values.
pub enum Content {
    /// Lines and labels.
    Drawing {
        /// The title, for those who can't see the drawing.
        title: &'static str,
        /// The caption, in Markdown with formulas.
        caption: &'static str,
        /// Draws it.
        draw: fn(&ParameterValues) -> Drawing,
    },
    /// Pixels, whose description and caption are in their chapter.
    Picture {
        /// Draws it with at most this many columns.
        draw: fn(&ParameterValues, u32) -> RgbImage,
    },
}

/// Texts by name: numbers and vectors, formatted for the page, and some words.
pub type Readouts = BTreeMap<String, String>;

/// Readouts with these names.
pub fn collect_readouts<const N: usize>(texts: [(&str, String); N]) -> Readouts {
    texts.map(|(name, text)| (name.into(), text)).into()
}

/// A scene of which the reader sets everything. Its parameters belong to objects, and the page has
/// the controls of one object at a time.
pub struct EditableScene {
    /// The Rust program that draws it.
    pub program: fn(&ParameterValues) -> String,
    /// The object that is seen at a position.
    pub object_at: fn(&ParameterValues, DVec2) -> Option<&'static str>,
    /// The objects that have a colour, and the parameters of its three channels.
    pub colours: Vec<(&'static str, [ParameterId; 3])>,
}

impl Figure {
    /// A figure that shows this, and nothing else.
    pub(crate) fn new(name: &'static str, content: Content) -> Self {
        Self {
            name,
            content,
            followed: None,
            parameters: vec![],
            handles: vec![],
            readouts: |_| Readouts::new(),
            editable_scene: None,
            is_allowed: |_| true,
        }
    }

    /// The value of each parameter in the printed book.
    pub fn default_values(&self) -> ParameterValues {
        self.parameters.iter().map(|parameter| (parameter.id, parameter.default)).collect()
    }

    /// The handle that is a probe, if there is one.
    pub fn probe(&self) -> Option<&Handle> {
        self.handles.iter().find(|handle| handle.mark == Mark::Probe)
    }

    /// The default values with the probe at the pixel (i, j). None if there is no probe, or no such
    /// pixel.
    pub fn values_at_pixel(&self, [i, j]: [f64; 2]) -> Option<ParameterValues> {
        let probe = self.probe()?;
        let mut values = self.default_values();
        values.set(probe.horizontal, i);
        values.set(probe.vertical, j);
        let allowed = self.snap_if_allowed(&values)?;
        (allowed == values).then_some(values)
    }

    /// The values after a handle was dragged to a position; None if nothing is allowed there.
    pub fn drag_handle(
        &self,
        values: &ParameterValues,
        handle: &Handle,
        position: DVec2,
    ) -> Option<ParameterValues> {
        let DVec2 { x, y } = (handle.coordinates_at)(values, position);
        let mut new = values.clone();
        new.set(handle.horizontal, x);
        new.set(handle.vertical, y);
        self.snap_if_allowed(&new)
    }

    /// The allowed values that are nearest to these; None if there is nothing to show.
    pub fn snap_if_allowed(&self, values: &ParameterValues) -> Option<ParameterValues> {
        let allowed = self
            .parameters
            .iter()
            .map(|parameter| (parameter.id, parameter.nearest_allowed(values[parameter.id])));
        let allowed = allowed.collect();
        (values.are_finite() && (self.is_allowed)(&allowed)).then_some(allowed)
    }
}
