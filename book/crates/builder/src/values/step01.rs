//! The numbers of the introduction and of the chapters of step 1.

use super::Values;
use super::rays::{camera, pixel_ray, row, unit_ray};
use figures::{format_fixed, format_number, format_vector};
use glam::DVec3;
use step01_rays::{AspectRatio, direction_colour, picture};

pub const VALUES: &Values = &[
    ("camera-tan", || format_number(-camera().matrix.z_axis.x)),
    ("camera-v0-x", || format_number(camera().matrix.z_axis.x)),
    ("camera-v0-y", || format_number(camera().matrix.z_axis.y)),
    ("step01-row-v6", || format_number(row(7).direction(6.0).x)),
    ("step01-row-middle-angle", || format_fixed(angle_between(2.0, 3.0), 1)),
    ("step01-row-edge-angle", || format_fixed(angle_between(0.0, 1.0), 1)),
    ("step01-step", || format_fixed(camera().matrix.x_axis.x, 6)),
    ("step01-down", || format_fixed(camera().matrix.y_axis.y, 6)),
    ("step01-pixel-x", || format_number(pixel_ray(PIXEL).direction.x)),
    ("step01-pixel-y", || format_number(pixel_ray(PIXEL).direction.y)),
    ("step01-pixel-intensity", || format_vector(direction_colour(&pixel_ray(PIXEL)))),
    ("step01-pixel-colour", || format_vector(pixel_bytes(PIXEL))),
    ("step01-corner-length", || format_number(pixel_ray([0, 0]).direction.length())),
    ("step01-unit-blue", || {
        format_fixed(255.0 * direction_colour(&unit_ray(&pixel_ray([0, 0]))).z, 0)
    }),
    ("step01-rows-scope", || {
        format_number(AspectRatio { width: 2.35, height: 1.0 }.v_res(640).into())
    }),
];

/// The pixel of the worked example.
const PIXEL: [u32; 2] = [480, 90];

/// The angle between two rays of the figure's row, in degrees.
fn angle_between(i: f64, k: f64) -> f64 {
    row(7).direction(i).angle_to(row(7).direction(k)).abs().to_degrees()
}

/// The bytes of a pixel of step 1's picture.
fn pixel_bytes([i, j]: [u32; 2]) -> DVec3 {
    DVec3::from(picture(&camera(), 1)[(i, j)].0.map(f64::from))
}
