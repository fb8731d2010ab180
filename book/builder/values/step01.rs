//! The numbers of the introduction and of chapter 1.

use super::Value;
use super::measure::{camera, number, rgb, tenths, vector};
use live::Row;
use step01_rays::{AspectRatio, direction_colour, picture};

pub const VALUES: &[Value] = &[
    ("camera-tan", || number((60_f64.to_radians() / 2.0).tan())),
    ("camera-v0-x", || number(camera().matrix.z_axis.x)),
    ("camera-v0-y", || number(camera().matrix.z_axis.y)),
    ("step01-row-d", || number(row().matrix.x_axis.x)),
    ("step01-row-v0", || number(row().direction(0.0).x)),
    ("step01-row-v6", || number(row().direction(6.0).x)),
    ("step01-row-middle-angle", || between(2.0, 3.0)),
    ("step01-row-edge-angle", || between(0.0, 1.0)),
    ("step01-row-short-angle", || between(0.0, 6.0 * 6.0 / 7.0)),
    ("step01-step", || format!("{:.6}", camera().matrix.x_axis.x)),
    ("step01-down", || format!("{:.6}", camera().matrix.y_axis.y)),
    ("step01-pixel-x", || number(camera().ray(480.0, 90.0).direction.x)),
    ("step01-pixel-y", || number(camera().ray(480.0, 90.0).direction.y)),
    ("step01-pixel-intensity", || {
        vector(direction_colour(&camera().ray(480.0, 90.0)))
    }),
    ("step01-pixel-colour", || pixel(480, 90)),
    ("step01-corner-length", || number(camera().ray(0.0, 0.0).direction.length())),
    ("step01-top-left", || pixel(0, 0)),
    ("step01-top-right", || pixel(639, 0)),
    ("step01-bottom-left", || pixel(0, 359)),
    ("step01-bottom-right", || pixel(639, 359)),
    ("step01-unit-blue", || {
        let mut ray = camera().ray(0.0, 0.0);
        ray.direction = ray.direction.normalize();
        format!("{:.0}", 255.0 * direction_colour(&ray).z)
    }),
    ("step01-rows-scope", || {
        let scope = AspectRatio { width: 2.35, height: 1.0 };
        scope.v_res(640).to_string()
    }),
    ("step01-half-light", || format!("{:.2}", 0.5_f64.powf(2.2))),
];

/// The row of the figure: 7 rays, 60 degrees.
fn row() -> Row {
    Row::new(7, 60_f64.to_radians())
}

/// The angle between two rays of that row, in degrees.
fn between(i: f64, k: f64) -> String {
    tenths(row().direction(i).angle_to(row().direction(k)).abs().to_degrees())
}

/// The colour of a pixel of step 1's picture.
fn pixel(i: u32, j: u32) -> String {
    rgb(picture(&camera(), 1).get_pixel(i, j).0)
}
