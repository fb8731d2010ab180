//! The probe of a picture: a cross at the pixel whose trace is told.

use crate::projection::SIZE;
use crate::{ControlKind, Handle, Mark, Parameter, View, array};
use glam::{DVec2, dvec2};
use step01_rays::{Camera, Ray};

/// The pixel of the probe, and the columns of the picture that is drawn.
pub struct Probe {
    pub i: f64,
    pub j: f64,
    columns: f64,
}

impl Probe {
    /// The first parameters of a picture with a probe, whose default is the pixel (i, j).
    pub fn parameters([i, j]: [f64; 2]) -> Vec<Parameter> {
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
        course::camera().ray(self.i, self.j)
    }

    /// The camera of the picture that is drawn.
    pub fn camera(&self) -> Camera {
        course::camera_with_fov(60.0, self.columns)
    }

    /// The handle, a cross at the pixel.
    pub fn handle() -> Handle {
        // The middle of a pixel.
        let view = View { origin: DVec2::splat(0.5), scale: dvec2(1.0, -1.0) };
        let handle = Handle::of_point("the pixel that you ask", 0, view);
        Handle { is_down: true, mark: Mark::Probe, ..handle }
    }
}

/// The columns of a picture, without a control.
pub fn columns_parameter() -> Parameter {
    let range = [2.0, SIZE.x];
    let parameter = Parameter::new(["hRes", "columns", ""], SIZE.x, range, 1.0);
    Parameter { control: ControlKind::Columns, has_control: |_, _| false, ..parameter }
}
