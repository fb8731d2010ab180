use crate::View;
use glam::DVec2;

/// A mark in a figure or picture that the reader drags, or moves by the arrow keys.
pub struct Handle {
    /// The name in words.
    pub words: String,
    /// The two parameters that it sets: sideways, and up and down. Both may be one.
    pub parameters: [usize; 2],
    /// Whether the second parameter grows downwards, as rows do.
    pub is_down: bool,
    /// The mark that is drawn.
    pub mark: Mark,
    /// Its place at these values, in the coordinates of the drawing or in pixels; None if
    /// there is nothing to drag.
    pub locate: Box<Locate>,
    /// The values of its two parameters that bring it to a place, or near it.
    pub coordinates_at: Box<CoordinatesAt>,
}

type Locate = dyn Fn(&[f64]) -> Option<DVec2> + Send + Sync;
type CoordinatesAt = dyn Fn(&[f64], DVec2) -> DVec2 + Send + Sync;

/// The mark of a handle; a reply has its name in small letters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A ring, which moves a part of the output.
    Point,
    /// A dotted ring, which moves a light.
    Light,
    /// A cross at the pixel whose trace is told; it moves nothing.
    Probe,
}

impl Handle {
    /// The handle of a point of a drawing whose x and y are the parameter `x` and the next.
    pub fn of_point(words: &str, x: usize, view: View) -> Self {
        Self {
            words: words.to_owned(),
            parameters: [x, x + 1],
            is_down: false,
            mark: Mark::Point,
            locate: Box::new(move |values| Some(view.to_drawing(DVec2::from_slice(&values[x..])))),
            coordinates_at: Box::new(move |_, place| view.to_world(place)),
        }
    }
}
