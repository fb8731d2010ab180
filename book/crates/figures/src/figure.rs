use crate::{Drawing, Handle, Mark, Parameter};
use glam::DVec2;
use image::RgbImage;
use std::collections::BTreeMap;

/// A drawing, or the pixels of a picture.
pub enum Output {
    /// Lines and labels.
    Drawing(Drawing),
    /// Pixels.
    Pixels(RgbImage),
}

/// Numbers by name, formatted for the page; some are vectors or words.
pub type Numbers = BTreeMap<String, String>;

/// Numbers with these names.
pub fn collect_numbers<const N: usize>(numbers: [(&str, String); N]) -> Numbers {
    numbers.map(|(name, text)| (name.into(), text)).into()
}

/// A figure or a picture as a page asks for it: by a name, and numbers without names.
pub struct Figure {
    /// The name in chapters and requests.
    pub name: &'static str,
    /// The title of a figure, for those who can't see it; empty for a picture, whose chapter
    /// has it.
    pub title: &'static str,
    /// The caption of a figure; Markdown, with formulas.
    pub caption: &'static str,
    /// The figure whose values this one takes, instead of having controls.
    pub followed: Option<&'static str>,
    /// The numbers that the reader sets.
    pub parameters: Vec<Parameter>,
    /// The marks that the reader drags.
    pub handles: Vec<Handle>,
    /// The drawing or the pixels at these values.
    pub draw: fn(&[f64]) -> Output,
    /// The numbers in the text that depend on these values.
    pub numbers: fn(&[f64]) -> Numbers,
    /// The group of the object that is seen at a place, at these values.
    pub group_at: fn(&[f64], DVec2) -> Option<&'static str>,
    /// Whether there is something to draw at these values.
    pub is_allowed: fn(&[f64]) -> bool,
}

impl Figure {
    /// One of a name and what it draws; its other fields are empty.
    pub(crate) fn new(name: &'static str, draw: fn(&[f64]) -> Output) -> Self {
        Self {
            name,
            title: "",
            caption: "",
            followed: None,
            parameters: vec![],
            handles: vec![],
            draw,
            numbers: |_| Numbers::new(),
            group_at: |_, _| None,
            is_allowed: |_| true,
        }
    }

    /// The value of each parameter in the printed book.
    pub fn default_values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// The drawing or the pixels in the printed book.
    pub fn default_output(&self) -> Output {
        (self.draw)(&self.default_values())
    }

    /// Whether a handle is a probe.
    pub fn has_probe(&self) -> bool {
        self.handles.iter().any(|handle| handle.mark == Mark::Probe)
    }

    /// The values after a handle was dragged to a place; None if nothing is allowed
    /// there.
    pub fn drag_handle(&self, values: &[f64], handle: &Handle, place: DVec2) -> Option<Vec<f64>> {
        let mut new = values.to_vec();
        let [first, second] = handle.parameters;
        [new[first], new[second]] = (handle.coordinates_at)(values, place).to_array();
        self.snap_if_allowed(&new)
    }

    /// The allowed values that are nearest to these; None if there is nothing to draw.
    pub fn snap_if_allowed(&self, values: &[f64]) -> Option<Vec<f64>> {
        let is_complete =
            values.len() == self.parameters.len() && values.iter().all(|value| value.is_finite());
        let pairs = self.parameters.iter().zip(values);
        let values: Vec<_> =
            pairs.map(|(parameter, value)| parameter.nearest_allowed(*value)).collect();
        (is_complete && (self.is_allowed)(&values)).then_some(values)
    }
}
