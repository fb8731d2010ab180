//! Handles: the marks in a figure that the reader can drag.

use crate::probe::SIZE;
use crate::{ParameterId, ParameterValues, PointId, View, direction_left_of_up};
use glam::{DVec2, DVec3};
use std::fmt::{self, Debug, Formatter};
use step01_rays::Camera;

/// A mark in a figure. The reader can drag the mark, or move it with the arrow keys.
///
/// The position of a handle is in the coordinates of a drawing, or in the pixels of a picture.
pub struct Handle {
    /// The handle's name, which a tooltip shows and a screen reader says.
    pub label: &'static str,
    /// The appearance of the mark.
    pub mark: Mark,
    /// The parameter that the left and right arrow keys change.
    pub horizontal: ParameterId,
    /// The parameter that the up and down arrow keys change. It may be the same as `horizontal`.
    pub vertical: ParameterId,
    /// The parameter for the z of the handle's object. Dragging with the Shift key changes this z.
    /// None if the handle can't change a z.
    pub depth: Option<ParameterId>,
    /// The switch that adds the handle's object to the scene. None if there is no such switch.
    pub presence: Option<ParameterId>,
    /// Returns the handle's position for the given parameter values, or None if there is nothing to
    /// drag.
    pub locate: Box<Locate>,
    /// Returns the values that `horizontal` and `vertical` get when the handle is dragged to a
    /// position. The two values are equal if `horizontal` and `vertical` are the same parameter.
    /// Returns None if there is nothing to drag.
    pub coordinates_at: Box<CoordinatesAt>,
}

type Locate = dyn Fn(&ParameterValues) -> Option<DVec2> + Send + Sync;
type CoordinatesAt = dyn Fn(&ParameterValues, DVec2) -> Option<DVec2> + Send + Sync;

/// Omits the closures, which can't be printed.
impl Debug for Handle {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Self { label, mark, horizontal, vertical, depth, presence, .. } = self;
        f.debug_struct("Handle")
            .field("label", label)
            .field("mark", mark)
            .field("horizontal", horizontal)
            .field("vertical", vertical)
            .field("depth", depth)
            .field("presence", presence)
            .finish_non_exhaustive()
    }
}

/// The appearance of a handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A ring that moves a part of the figure.
    Point,
    /// A dotted ring that moves a light.
    Light,
    /// A cross at the pixel whose trace the page shows. Dragging the cross doesn't change the
    /// picture.
    Probe,
}

impl Mark {
    /// The name of the mark in a reply.
    pub fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Light => "light",
            Self::Probe => "probe",
        }
    }
}

impl Handle {
    /// A handle that sets two parameters. The arguments become the fields with the same names.
    pub fn new(
        label: &'static str,
        [horizontal, vertical]: [ParameterId; 2],
        locate: impl Fn(&ParameterValues) -> Option<DVec2> + Send + Sync + 'static,
        coordinates_at: impl Fn(&ParameterValues, DVec2) -> Option<DVec2> + Send + Sync + 'static,
    ) -> Self {
        Self {
            label,
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
        label: &'static str,
        parameter: ParameterId,
        locate: impl Fn(&ParameterValues) -> DVec2 + Send + Sync + 'static,
        value_at: impl Fn(&ParameterValues, DVec2) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let value_at = move |values: &ParameterValues, position| {
            Some(DVec2::splat(value_at(values, position)))
        };
        Self::new(label, [parameter; 2], move |values| Some(locate(values)), value_at)
    }

    /// A handle that sets an angle, and moves on a circle around the origin of `view`. The angle is
    /// 0° straight up and 90° to the left. It ranges from −90° to 270°.
    pub fn of_degrees_left_of_up(
        label: &'static str,
        parameter: ParameterId,
        view: View,
        distance: f64,
    ) -> Self {
        let locate = move |values: &ParameterValues| {
            view.to_drawing(distance * direction_left_of_up(values[parameter]))
        };
        Self::of_parameter(label, parameter, locate, move |_, position| {
            (view.degrees_left_of_up(position) + 90.0).rem_euclid(360.0) - 90.0
        })
    }

    /// A handle that moves a point in a drawing.
    pub fn of_point_in_drawing(point: PointId, view: View) -> Self {
        let locate = move |values: &ParameterValues| Some(view.to_drawing(values.point(point)));
        let coordinates = [point.x(), point.y()];
        Self::new(point.0, coordinates, locate, move |_, position| Some(view.to_world(position)))
    }

    /// A handle in a picture. The handle sets the x and y of a point in the world, and the point's
    /// z doesn't change. If the ray through the new position of the handle never reaches this z,
    /// the handle stays where it is. The handle can't be dragged closer to the picture's border
    /// than `margin`. There is nothing to drag while `camera_and_point` returns None.
    pub fn of_world_xy_in_picture(
        label: &'static str,
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
            // Solves p = C + d [D_u D_v V_0] (i, j, 1)ᵀ for i, j and the depth d.
            let pixel = camera.matrix.inverse() * (point - camera.centre);
            (pixel.z > 0.0).then(|| pixel.truncate() / pixel.z + 0.5)
        };
        Self::new(label, coordinates, locate, move |values, position| {
            let (camera, point) = camera_and_point(values)?;
            let pixel = position.clamp(DVec2::splat(margin), SIZE - margin) - 0.5;
            let ray = camera.ray(pixel.x, pixel.y);
            let t = (point.z - ray.start.z) / ray.direction.z;
            let is_ahead = t > 0.0 && t.is_finite();
            Some(if is_ahead { ray.at(t).truncate() } else { point.truncate() })
        })
    }

    /// Whether the handle sets this parameter, or moves the object that the parameter belongs to.
    pub fn moves_parameter_or_its_object(&self, parameter: ParameterId) -> bool {
        let is_of_same_object =
            parameter.object().is_some() && parameter.object() == self.horizontal.object();
        is_of_same_object || [self.horizontal, self.vertical].contains(&parameter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn angle_of_a_handle_is_between_minus_90_and_270_degrees() {
        const ANGLE: ParameterId = ParameterId::new("angle");
        let view = View { origin: dvec2(100.0, 50.0), scale: DVec2::ONE };
        let handle = Handle::of_degrees_left_of_up("the arm", ANGLE, view, 40.0);
        let values = |angle| [(ANGLE, angle)].into_iter().collect();
        for (to, angle) in [
            (-89.0, -89.0),
            (0.0, 0.0),
            (180.0, 180.0),
            (269.0, 269.0),
            (271.0, -89.0),
            (-91.0, 269.0),
        ] {
            let position = (handle.locate)(&values(to)).expect("the handle has a position");
            let new =
                (handle.coordinates_at)(&values(0.0), position).expect("the handle can be dragged");
            assert!((new - angle).length() < 1e-9, "{to}: {new}");
        }
    }
}
