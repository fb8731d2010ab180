use crate::probe::SIZE;
use crate::{View, direction_left_of_up};
use glam::{DVec2, DVec3};
use step01_rays::Camera;

/// A mark in a figure or picture that the reader drags, or moves by the arrow keys.
pub struct Handle {
    /// The name in words.
    pub words: String,
    /// The two parameters that it sets: sideways, and up and down. Both may be one.
    pub parameters: [usize; 2],
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
    /// A handle that sets two parameters; see the fields.
    pub fn new(
        words: &str,
        parameters: [usize; 2],
        locate: impl Fn(&[f64]) -> Option<DVec2> + Send + Sync + 'static,
        coordinates_at: impl Fn(&[f64], DVec2) -> DVec2 + Send + Sync + 'static,
    ) -> Self {
        let (locate, coordinates_at) = (Box::new(locate), Box::new(coordinates_at));
        Self { words: words.to_owned(), parameters, mark: Mark::Point, locate, coordinates_at }
    }

    /// A handle that sets one parameter.
    pub fn of_one(
        words: &str,
        parameter: usize,
        locate: impl Fn(&[f64]) -> DVec2 + Send + Sync + 'static,
        value_at: impl Fn(&[f64], DVec2) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let value_at = move |values: &[f64], place| DVec2::splat(value_at(values, place));
        Self::new(words, [parameter; 2], move |values| Some(locate(values)), value_at)
    }

    /// The handle of an angle to the left of straight up, at this distance from the origin. Far
    /// to the right of it, the angle is a large one.
    pub fn of_angle(words: &str, parameter: usize, view: View, distance: f64) -> Self {
        let locate = move |values: &[f64]| {
            view.to_drawing(distance * direction_left_of_up(values[parameter]))
        };
        Self::of_one(words, parameter, locate, move |_, place| {
            (view.degrees_left_of_up(place) + 90.0).rem_euclid(360.0) - 90.0
        })
    }

    /// The handle of a point of a drawing whose x and y are the parameter `x` and the next.
    pub fn of_point(words: &str, x: usize, view: View) -> Self {
        let locate = move |values: &[f64]| Some(view.to_drawing(DVec2::from_slice(&values[x..])));
        Self::new(words, [x, x + 1], locate, move |_, place| view.to_world(place))
    }

    /// The handle of a point of the world in a picture, whose x and y are the parameter `x`
    /// and the next; its z stays. It is dragged at most to `margin` from the border, and stays
    /// where no point at its z is ahead. There is nothing to drag where the function gives None.
    pub fn in_picture(
        words: &str,
        x: usize,
        margin: f64,
        camera_and_point: impl Fn(&[f64]) -> Option<(Camera, DVec3)> + Send + Sync + Copy + 'static,
    ) -> Self {
        let locate = move |values: &[f64]| {
            let (camera, point) = camera_and_point(values)?;
            // In p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is the depth.
            let pixel = camera.matrix.inverse() * (point - camera.centre);
            (0.0 < pixel.z).then(|| pixel.truncate() / pixel.z + 0.5)
        };
        Self::new(words, [x, x + 1], locate, move |values, place| {
            let Some((camera, point)) = camera_and_point(values) else { return DVec2::NAN };
            let pixel = place.clamp(DVec2::splat(margin), SIZE - margin) - 0.5;
            let ray = camera.ray(pixel.x, pixel.y);
            let t = (point.z - ray.start.z) / ray.direction.z;
            let is_ahead = 0.0 < t && t.is_finite();
            if is_ahead { ray.at(t).truncate() } else { point.truncate() }
        })
    }
}
