use crate::{Drawing, Handle, Mark, Parameter};
use glam::DVec2;
use image::RgbImage;
use std::collections::BTreeMap;

/// A figure or a picture that answers when a parameter moves. One without parameters
/// stays as it is.
#[derive(Clone, Debug)]
pub struct Live {
    /// The name in chapters and requests.
    pub name: &'static str,
    /// The title of a figure, for those who can't see it; empty for a picture, whose
    /// chapter has it.
    pub title: &'static str,
    /// The caption of a figure; Markdown, with formulas.
    pub caption: &'static str,
    /// The numbers that the reader sets.
    pub parameters: Vec<Parameter>,
    /// The marks that the reader drags.
    pub handles: Vec<Handle>,
    /// Whether there is something to draw at these values.
    pub is_allowed: fn(&[f64]) -> bool,
    /// The drawing or picture at these values.
    pub draw: fn(&[f64]) -> Output,
    /// The numbers in the text that depend on these values.
    pub numbers: fn(&[f64]) -> Numbers,
    /// Another figure that is drawn at the same values.
    pub companion: Option<Companion>,
}

/// A figure that is drawn at the values of another.
#[derive(Clone, Copy, Debug)]
pub struct Companion {
    /// The name of the figure.
    pub name: &'static str,
    /// The drawing at the values of the other.
    pub draw: fn(&[f64]) -> Drawing,
}

/// Numbers by name, formatted for the page; some are vectors or words.
pub type Numbers = BTreeMap<String, String>;

/// A drawing or a picture.
#[derive(Clone, Debug)]
pub enum Output {
    /// Lines and labels.
    Drawing(Drawing),
    /// Pixels.
    Picture(RgbImage),
}

impl Output {
    /// The width and the height.
    pub fn width_and_height(&self) -> [f64; 2] {
        match self {
            Self::Drawing(drawing) => drawing.width_and_height(),
            Self::Picture(picture) => [picture.width(), picture.height()].map(f64::from),
        }
    }
}

impl Live {
    /// A figure or picture without parameters.
    pub fn new(name: &'static str, draw: fn(&[f64]) -> Output) -> Self {
        Self {
            name,
            title: "",
            caption: "",
            parameters: vec![],
            handles: vec![],
            is_allowed: |_| true,
            draw,
            numbers: |_| Numbers::new(),
            companion: None,
        }
    }

    /// The value of each parameter in the printed book.
    pub fn default_values(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// The drawing or picture in the printed book.
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
        let coordinates = (handle.values_at)(handle, values, place).to_array();
        for (index, value) in handle.parameters.into_iter().zip(coordinates) {
            new[index] = value;
        }
        self.snap_if_allowed(&new)
    }

    /// The values after a handle was moved by some steps of its parameters, to the right
    /// and upwards.
    pub fn step_handle(&self, values: &[f64], handle: &Handle, steps: DVec2) -> Option<Vec<f64>> {
        let mut new = values.to_vec();
        let second = if handle.is_down { -steps.y } else { steps.y };
        for (index, steps) in handle.parameters.into_iter().zip([steps.x, second]) {
            new[index] += steps / self.parameters[index].steps_per_unit;
        }
        // As by dragging, it stays inside the picture.
        self.drag_handle(&new, handle, handle.place(&new)?)
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

/// Numbers with these names.
pub fn collect_numbers<const N: usize>(numbers: [(&str, String); N]) -> Numbers {
    numbers.map(|(name, text)| (name.into(), text)).into()
}
