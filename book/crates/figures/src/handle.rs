use glam::{DVec2, dvec2};

/// A mark in a figure or picture that the reader drags, or moves by the arrow keys.
#[derive(Clone, Debug)]
pub struct Handle {
    /// The name in words.
    pub words: String,
    /// The two parameters that it sets: sideways, and up and down.
    pub parameters: [usize; 2],
    /// The place at these values, in the coordinates of the drawing or in pixels; None
    /// if there is nothing to drag.
    pub locate: fn(&Handle, &[f64]) -> Option<DVec2>,
    /// The values of the two parameters that bring it to a place, or near it.
    pub values_at: fn(&Handle, &[f64], DVec2) -> DVec2,
    /// Whether the second parameter grows downwards, as rows do.
    pub is_down: bool,
    /// The mark that is drawn.
    pub mark: Mark,
}

/// The mark of a handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A ring, which moves a part of the output.
    Point,
    /// A dotted ring, which moves a light.
    Light,
    /// A cross at the pixel whose trace is told; it moves nothing.
    Probe,
}

impl Mark {
    /// The name of the mark in an answer.
    pub fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Light => "light",
            Self::Probe => "probe",
        }
    }
}

impl Handle {
    /// A handle that sets two parameters; the second grows upwards.
    pub fn new(
        words: impl Into<String>,
        parameters: [usize; 2],
        locate: fn(&Self, &[f64]) -> Option<DVec2>,
        values_at: fn(&Self, &[f64], DVec2) -> DVec2,
    ) -> Self {
        let (words, is_down, mark) = (words.into(), false, Mark::Point);
        Self { words, parameters, locate, values_at, is_down, mark }
    }

    /// The place at these values of all parameters.
    pub fn place(&self, values: &[f64]) -> Option<DVec2> {
        (self.locate)(self, values)
    }

    /// The values of the two parameters.
    pub fn coordinates(&self, values: &[f64]) -> DVec2 {
        let [x, y] = self.parameters.map(|index| values[index]);
        dvec2(x, y)
    }
}
