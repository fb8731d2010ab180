//! A mark in a figure that the reader drags.

use crate::probe::SIZE;
use crate::{ParameterId, ParameterValues, PointId, View, direction_left_of_up};
use glam::{DVec2, DVec3};
use step01_rays::Camera;

/// A mark in a drawing or a picture that the reader drags, or moves by the arrow keys.
///
/// Its position is in the coordinates of the drawing, or in pixels.
pub struct Handle {
    /// The name in words.
    pub words: &'static str,
    /// The mark that is drawn.
    pub mark: Mark,
    /// The parameter that the left and right arrow keys change.
    pub horizontal: ParameterId,
    /// The parameter that the up and down arrow keys change. It may be the same one.
    pub vertical: ParameterId,
    /// The parameter that says how far towards the reader it is, if the page lets it be moved that
    /// way.
    pub depth: Option<ParameterId>,
    /// The switch that takes what it moves into the scene, if there is one.
    pub presence: Option<ParameterId>,
    /// Its position at these values; None if there is nothing to drag.
    pub locate: Box<Locate>,
    /// The values of `horizontal` and `vertical` that bring it to a position, or near it. Where
    /// both are one parameter, so are the two values.
    pub coordinates_at: Box<CoordinatesAt>,
}

type Locate = dyn Fn(&ParameterValues) -> Option<DVec2> + Send + Sync;
type CoordinatesAt = dyn Fn(&ParameterValues, DVec2) -> DVec2 + Send + Sync;

/// The mark of a handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A ring, which moves a part of the figure.
    Point,
    /// A dotted ring, which moves a light.
    Light,
    /// A cross at the pixel whose trace is read out. It moves nothing.
    Probe,
}

impl Mark {
    /// The name in a reply.
    pub fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Light => "light",
            Self::Probe => "probe",
        }
    }
}

impl Handle {
    /// A handle that sets two parameters; see the fields.
    pub fn new(
        words: &'static str,
        [horizontal, vertical]: [ParameterId; 2],
        locate: impl Fn(&ParameterValues) -> Option<DVec2> + Send + Sync + 'static,
        coordinates_at: impl Fn(&ParameterValues, DVec2) -> DVec2 + Send + Sync + 'static,
    ) -> Self {
        Self {
            words,
            mark: Mark::Point,
            horizontal,
            vertical,
            depth: None,
            presence: None,
            locate: Box::new(locate),
            coordinates_at: Box::new(coordinates_at),
        }
    }

    /// A handle that sets one parameter.
    pub fn of_parameter(
        words: &'static str,
        parameter: ParameterId,
        locate: impl Fn(&ParameterValues) -> DVec2 + Send + Sync + 'static,
        value_at: impl Fn(&ParameterValues, DVec2) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let value_at =
            move |values: &ParameterValues, position| DVec2::splat(value_at(values, position));
        Self::new(words, [parameter; 2], move |values| Some(locate(values)), value_at)
    }

    /// The handle of an angle to the left of straight up, at this distance from the origin. Far to
    /// the right of it, the angle is a large one.
    pub fn of_angle(
        words: &'static str,
        parameter: ParameterId,
        view: View,
        distance: f64,
    ) -> Self {
        let locate = move |values: &ParameterValues| {
            view.to_drawing(distance * direction_left_of_up(values[parameter]))
        };
        Self::of_parameter(words, parameter, locate, move |_, position| {
            (view.degrees_left_of_up(position) + 90.0).rem_euclid(360.0) - 90.0
        })
    }

    /// The handle of a point of a drawing.
    pub fn of_point_in_drawing(point: PointId, view: View) -> Self {
        let locate = move |values: &ParameterValues| Some(view.to_drawing(values.point(point)));
        let coordinates = [point.x(), point.y()];
        Self::new(point.0, coordinates, locate, move |_, position| view.to_world(position))
    }

    /// The handle of a point of the world in a picture, whose x and y are these parameters; its z
    /// stays. It is dragged at most to `margin` from the border, and stays where it is if no point
    /// at its z is ahead. There is nothing to drag while `camera_and_point` gives None.
    pub fn of_world_point_in_picture(
        words: &'static str,
        coordinates: [ParameterId; 2],
        margin: f64,
        camera_and_point: impl Fn(&ParameterValues) -> Option<(Camera, DVec3)>
        + Send
        + Sync
        + Copy
        + 'static,
    ) -> Self {
        let locate = move |values: &ParameterValues| {
            let (camera, point) = camera_and_point(values)?;
            // In p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is the depth.
            let pixel = camera.matrix.inverse() * (point - camera.centre);
            (pixel.z > 0.0).then(|| pixel.truncate() / pixel.z + 0.5)
        };
        Self::new(words, coordinates, locate, move |values, position| {
            let Some((camera, point)) = camera_and_point(values) else { return DVec2::NAN };
            let pixel = position.clamp(DVec2::splat(margin), SIZE - margin) - 0.5;
            let ray = camera.ray(pixel.x, pixel.y);
            let t = (point.z - ray.start.z) / ray.direction.z;
            let is_ahead = t > 0.0 && t.is_finite();
            if is_ahead { ray.at(t).truncate() } else { point.truncate() }
        })
    }

    /// Whether the handle moves the object of this parameter, or sets it itself.
    pub fn moves(&self, parameter: ParameterId) -> bool {
        let is_of_same_object =
            parameter.object().is_some() && parameter.object() == self.horizontal.object();
        is_of_same_object || [self.horizontal, self.vertical].contains(&parameter)
    }
}
