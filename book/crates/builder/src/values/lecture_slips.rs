//! The numbers of the chapter on the slips of the lecture.

use super::rays::{camera, length_in_pixels, row};
use super::{Functions, Values};
use course::slide_matrix;
use figures::{format_fixed, format_number};
use glam::{DVec2, DVec3};
use step01_rays::Camera;
use step05_phong::reflect;

pub const VALUES: &Values = &[
    ("slips-first-v0-y", || format_number(first_v_0_y())),
    ("slips-first-v0-pixels", || format_number(rows_above_v_0(first_v_0_y()))),
    ("slips-slide-v0-y", || format_number(slide_matrix().matrix.z_axis.y)),
    ("slips-slide-v0-pixels", || format_number(rows_above_v_0(slide_matrix().matrix.z_axis.y))),
    ("slips-slide-d-v", || format_number(slide_matrix().matrix.y_axis.y)),
    ("slips-meant-d-v", || format_fixed(-2.0 * first_v_0_y() / 359.0, 6)),
    ("slips-meant-ratio", || format_number(length_in_pixels(2.0 * first_v_0_y() / 359.0))),
    ("slips-slide-times", || {
        format_fixed(slide_matrix().matrix.y_axis.y / camera().matrix.y_axis.y, 0)
    }),
    ("slips-row-last", || format_number(direction(639.0).x)),
    ("slips-i-twice-2", || format_number(length_in_pixels(direction(4.0).x - direction(0.0).x))),
    // If D itself had a factor i, ray i would have the direction of ray i².
    ("slips-i-twice-last", || format_number(direction(639.0 * 639.0).x)),
    ("slips-gate-n-l", || format_number(DVec3::Y.dot(low_light()))),
    ("slips-gate-r-v", || format_number(reflect(DVec3::Y, low_light()).dot(-low_light()))),
    ("slips-v-angle", || {
        format_number(degrees_down(&camera(), 359.0) - degrees_down(&camera(), 0.0))
    }),
];

pub const FUNCTIONS: &Functions = &[
    ("slide-row", |j| format_number(slide_matrix().ray(0.0, j).direction.y)),
    ("slide-angle", |j| format_fixed(degrees_down(&slide_matrix(), j), 1)),
    ("camera-angle", |j| format_fixed(degrees_down(&camera(), j), 1)),
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
