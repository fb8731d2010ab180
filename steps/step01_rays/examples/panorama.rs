//! A panorama: 360 degrees around and 180 degrees from top to bottom, with two
//! angles for each direction.

use glam::DVec3;
use image::RgbImage;
use std::f64::consts::{PI, TAU};
use step01_rays::{
    Camera, draw_and_save, draw_pixels, mean_colour, rgb8, sub_pixel_offsets,
};

/// The unit vector at a longitude and a latitude; both are 0 ahead, along −z.
pub fn direction(longitude: f64, latitude: f64) -> DVec3 {
    let around = DVec3::new(longitude.sin(), 0.0, -longitude.cos());
    latitude.cos() * around + latitude.sin() * DVec3::Y
}

/// The direction V of column `i` and row `j` of the panorama.
///
/// The columns divide the whole circle, and the rows the half circle from pole to
/// pole.
pub fn panoramic(camera: &Camera, i: f64, j: f64) -> DVec3 {
    let across = (i + 0.5) / f64::from(camera.h_res);
    let down = (j + 0.5) / f64::from(camera.v_res);
    direction((across - 0.5) * TAU, (0.5 - down) * PI)
}

/// The colour in the direction `v`, seen from the middle of a tiled cube with
/// coloured walls.
fn colour(v: DVec3) -> DVec3 {
    let wall = v / v.abs().max_element();
    let colour = match wall.to_array() {
        [1.0, ..] => DVec3::new(0.16, 0.60, 0.60),
        [-1.0, ..] => DVec3::new(0.44, 0.47, 0.78),
        [_, 1.0, _] => DVec3::new(0.97, 0.94, 0.90),
        [_, -1.0, _] => DVec3::new(0.80, 0.76, 0.82),
        [.., 1.0] => DVec3::new(0.96, 0.66, 0.56),
        _ => DVec3::new(0.91, 0.34, 0.28),
    };
    let tile = (3.0 * wall).floor().element_sum().rem_euclid(2.0);
    if tile < 1.0 { colour } else { 0.88 * colour }
}

/// The picture: the whole cube around the eye.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let centres = sub_pixel_offsets(samples);
    draw_pixels(camera, |i, j| {
        rgb8(mean_colour(&centres, |u, v| colour(panoramic(camera, i + u, j + v))))
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
