//! The probe of a picture, a cross at the pixel whose trace is told. The first values of such a
//! picture are the column and the row of that pixel, and the columns of the picture.

use crate::{ControlKind, Figure, Handle, Mark, Output, Parameter, View};
use glam::{DVec2, DVec3, dvec2};
use step01_rays::{Ray, render};

/// Columns and rows of the pictures of the course.
pub const SIZE: DVec2 = dvec2(640.0, 360.0);

/// The picture of the course with a probe, at first at the pixel (i, j), and with the parameters
/// that are set besides.
pub fn probed_picture(
    name: &'static str,
    [i, j]: [f64; 2],
    others: Vec<Parameter>,
    draw: fn(&[f64]) -> Output,
) -> Figure {
    let mut parameters = vec![
        Parameter::new(["i", "column", ""], i, [0.0, SIZE.x - 1.0], 1.0),
        Parameter::new(["j", "row", ""], j, [0.0, SIZE.y - 1.0], 1.0),
        columns_parameter(),
    ];
    parameters.extend(others);
    // The middle of a pixel.
    let view = View { origin: DVec2::splat(0.5), scale: dvec2(1.0, -1.0) };
    let handle = Handle::of_point("the pixel that you ask", 0, view);
    let handles = vec![Handle { mark: Mark::Probe, ..handle }];
    Figure { parameters, handles, ..Figure::new(name, draw) }
}

/// The ray of the probe's pixel.
pub fn probe_ray(values: &[f64]) -> Ray {
    course::camera().ray(values[0], values[1])
}

/// The picture in these colours, with the columns of these values.
pub fn draw_picture(values: &[f64], colour: impl Fn(&Ray) -> DVec3 + Sync) -> Output {
    Output::Pixels(render(&course::camera_with_fov(60.0, values[2]), 1, colour))
}

/// The columns of a picture, without a control.
pub fn columns_parameter() -> Parameter {
    let range = [2.0, SIZE.x];
    let parameter = Parameter::new(["hRes", "columns", ""], SIZE.x, range, 1.0);
    Parameter { control: ControlKind::Columns, has_control: |_, _| false, ..parameter }
}
