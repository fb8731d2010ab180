//! The numbers of the introduction and of the chapters of step 1.

use super::rays::{camera, pixel_ray, row, unit_ray};
use super::value::{
    Value::{Fixed, Number, Vector},
    Values,
};
use glam::DVec3;
use step01_rays::{AspectRatio, direction_colour, picture};

pub const VALUES: &Values = &[
    ("camera-tan", || Number(-camera().matrix.z_axis.x)),
    ("camera-v0-x", || Number(camera().matrix.z_axis.x)),
    ("camera-v0-y", || Number(camera().matrix.z_axis.y)),
    ("step01-row-v6", || Number(row(7).direction(6.0).x)),
    ("step01-row-middle-angle", || Fixed(1, angle_between(2.0, 3.0))),
    ("step01-row-edge-angle", || Fixed(1, angle_between(0.0, 1.0))),
    ("step01-step", || Fixed(6, camera().matrix.x_axis.x)),
    ("step01-down", || Fixed(6, camera().matrix.y_axis.y)),
    ("step01-pixel-x", || Number(pixel_ray(PIXEL).direction.x)),
    ("step01-pixel-y", || Number(pixel_ray(PIXEL).direction.y)),
    ("step01-pixel-intensity", || Vector(direction_colour(&pixel_ray(PIXEL)))),
    ("step01-pixel-colour", || Vector(pixel_bytes(PIXEL))),
    ("step01-corner-length", || Number(pixel_ray([0, 0]).direction.length())),
    ("step01-unit-blue", || Fixed(0, 255.0 * direction_colour(&unit_ray(&pixel_ray([0, 0]))).z)),
    ("step01-rows-scope", || Number(AspectRatio { width: 2.35, height: 1.0 }.v_res(640).into())),
    ("step01-half-light", || Fixed(2, 0.5_f64.powf(2.2))),
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
