//! The numbers of the chapter on the slips of the lecture.

use super::rays::{camera, length_in_pixels, row};
use super::value::{
    Functions,
    Value::{Fixed, Number},
    Values,
};
use course::slide_matrix;
use glam::{DVec2, DVec3};
use step01_rays::Camera;
use step05_phong::reflect;

pub const VALUES: &Values = &[
    ("slips-first-v0-y", || Number(first_v_0_y())),
    ("slips-first-v0-pixels", || Number(rows_above_v_0(first_v_0_y()))),
    ("slips-slide-v0-y", || Number(slide_matrix().matrix.z_axis.y)),
    ("slips-slide-v0-pixels", || Number(rows_above_v_0(slide_matrix().matrix.z_axis.y))),
    ("slips-slide-d-v", || Number(slide_matrix().matrix.y_axis.y)),
    ("slips-meant-d-v", || Fixed(6, -2.0 * first_v_0_y() / 359.0)),
    ("slips-meant-ratio", || Number(length_in_pixels(2.0 * first_v_0_y() / 359.0))),
    ("slips-slide-times", || Fixed(0, slide_matrix().matrix.y_axis.y / camera().matrix.y_axis.y)),
    ("slips-row-last", || Number(direction(639.0).x)),
    ("slips-i-twice-2", || Number(length_in_pixels(direction(4.0).x - direction(0.0).x))),
    // If D itself had a factor i, ray i would have the direction of ray i².
    ("slips-i-twice-last", || Number(direction(639.0 * 639.0).x)),
    ("slips-gate-n-l", || Number(DVec3::Y.dot(low_light()))),
    ("slips-gate-r-v", || Number(reflect(DVec3::Y, low_light()).dot(-low_light()))),
    ("slips-v-angle", || Number(degrees_down(&camera(), 359.0) - degrees_down(&camera(), 0.0))),
];

pub const FUNCTIONS: &Functions = &[
    ("slide-row", |j| Number(slide_matrix().ray(0.0, j).direction.y)),
    ("slide-angle", |j| Fixed(1, degrees_down(&slide_matrix(), j))),
    ("camera-angle", |j| Fixed(1, degrees_down(&camera(), j))),
];

/// The y of the lecture's first V_0: vRes / hRes · tan(θ/2).
fn first_v_0_y() -> f64 {
    360.0 / 640.0 * -camera().matrix.z_axis.x
}

/// The distance in rows from V_0 up to the height `y`.
fn rows_above_v_0(y: f64) -> f64 {
    length_in_pixels(y - camera().matrix.z_axis.y)
}

/// The angle below the horizon, in degrees, at which a camera looks through the middle of a
/// row.
fn degrees_down(camera: &Camera, j: f64) -> f64 {
    let v = camera.ray(319.5, j).direction;
    (-v.y).atan2(-v.z).to_degrees()
}

/// The direction of ray i of a row with the columns of the course's pictures.
fn direction(i: f64) -> DVec2 {
    row(640).direction(i)
}

/// The direction from the surface y = 0 to a light that is low behind it.
fn low_light() -> DVec3 {
    DVec3::new(40.0, -9.0, 0.0) / 41.0
}
