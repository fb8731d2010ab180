//! The probe in a picture: a cross at the pixel whose trace the page shows.

use crate::parameter::Axis;
use crate::{Content, Figure, Handle, Mark, Parameter, ParameterId, ParameterValues};
use course::{FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS};
use glam::{DVec2, DVec3, dvec2};
use image::RgbImage;
use step01_rays::{Ray, render};

/// The size of the course's pictures, in columns and rows.
pub const SIZE: DVec2 = dvec2(PICTURE_COLUMNS as f64, PICTURE_ROWS as f64);

/// The parameters for the column and row of the probe's pixel.
pub const I: ParameterId = ParameterId::new("i");
pub const J: ParameterId = ParameterId::new("j");

/// A figure that shows a picture as large as the course's pictures. The figure has
/// `other_parameters` and a probe, which is at the pixel (i, j) by default.
pub fn probed_picture(
    name: &'static str,
    [i, j]: [f64; 2],
    other_parameters: impl IntoIterator<Item = Parameter>,
    draw: fn(&ParameterValues, u32) -> RgbImage,
) -> Figure {
    let i = Parameter::number(I, "column", i, [0.0, SIZE.x - 1.0], 1.0);
    let j = Parameter::number(J, "row", j, [0.0, SIZE.y - 1.0], 1.0);
    let pixel_parameters =
        [i.with_symbol("i").with_axis(Axis::Right), j.with_symbol("j").with_axis(Axis::Down)];
    // The probe is at the centre of its pixel.
    let locate = |values: &ParameterValues| Some(dvec2(values[I], values[J]) + 0.5);
    let handle =
        Handle::new("the chosen pixel", [I, J], locate, |_, position| Some(position - 0.5));
    Figure {
        parameters: pixel_parameters.into_iter().chain(other_parameters).collect(),
        handles: vec![Handle { mark: Mark::Probe, ..handle }],
        ..Figure::new(name, Content::Picture { draw })
    }
}

/// The ray through the probe's pixel.
pub fn probe_ray(values: &ParameterValues) -> Ray {
    course::camera().ray(values[I], values[J])
}

/// Draws a picture with the course's camera. `colour` returns the colour that a ray sees.
pub fn draw_picture(columns: u32, colour: impl Fn(&Ray) -> DVec3 + Sync) -> RgbImage {
    render(&course::camera_with_fov(FOV_DEGREES, columns), 1, colour)
}
