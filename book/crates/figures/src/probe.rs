//! The probe of a picture: a cross at the pixel whose trace is told.

use crate::parameter::array;
use crate::pictures::step01::{self, WIDESCREEN};
use crate::{Handle, Kind, Mark, Parameter};
use glam::{DVec2, DVec3, dvec2};
use step01_rays::{Camera, Ray};

/// Columns and rows of the pictures of the course.
pub const SIZE: DVec2 = dvec2(640.0, 360.0);

/// The pixel of the probe, and the columns of the picture that is drawn.
pub struct Probe {
    /// The column.
    pub i: f64,
    /// The row.
    pub j: f64,
    /// The columns of the picture.
    pub columns: f64,
}

impl Probe {
    /// The first parameters of a picture with a probe, whose default is the pixel (i, j).
    pub fn parameters(i: f64, j: f64) -> Vec<Parameter> {
        vec![
            Parameter::new(["i", "column", ""], i, [0.0, SIZE.x - 1.0], 1.0),
            Parameter::new(["j", "row", ""], j, [0.0, SIZE.y - 1.0], 1.0),
            columns_parameter(),
        ]
    }

    /// The probe of the first values, and the other values.
    pub fn split_values(values: &[f64]) -> (Self, &[f64]) {
        let (first, others) = values.split_at(3);
        let [i, j, columns] = array(first);
        (Self { i, j, columns }, others)
    }

    /// The ray of the pixel, in the picture of the course.
    pub fn ray(&self) -> Ray {
        crate::camera().ray(self.i, self.j)
    }

    /// The camera of the picture that is drawn.
    pub fn camera(&self) -> Camera {
        step01::camera(60.0, WIDESCREEN, self.columns)
    }

    /// The handle, a cross at the pixel.
    pub fn handle() -> Handle {
        let handle = Handle::new(
            "the pixel that you ask",
            [0, 1],
            |handle, values| Some(handle.coordinates(values) + 0.5),
            |_, _, place| place - 0.5,
        );
        Handle { is_down: true, mark: Mark::Probe, ..handle }
    }
}

/// The columns of a picture, without a control.
pub fn columns_parameter() -> Parameter {
    let range = [2.0, SIZE.x];
    let parameter = Parameter::new(["hRes", "columns", ""], SIZE.x, range, 1.0);
    Parameter { kind: Kind::Columns, has_control: |_, _| false, ..parameter }
}

/// The place of a point of the world in the picture of a camera; None behind the eye.
///
/// In p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is the depth.
pub fn place_of_point(camera: &Camera, p: DVec3) -> Option<DVec2> {
    let pixel = camera.matrix.inverse() * (p - camera.centre);
    (0.0 < pixel.z).then(|| pixel.truncate() / pixel.z + 0.5)
}

/// The x and y of the point of the world at a place in the picture and at this z; None
/// where the ray of that place leads to no such point.
pub fn point_at_place(camera: &Camera, place: DVec2, z: f64) -> Option<DVec2> {
    let pixel = place - 0.5;
    let ray = camera.ray(pixel.x, pixel.y);
    let t = (z - ray.start.z) / ray.direction.z;
    (0.0 < t && t.is_finite()).then(|| ray.at(t).truncate())
}
