//! The direction in which each surface faces, as a colour.

use image::RgbImage;
use step04_diffuse::{
    Camera, OBJECTS, direction_colour, draw_and_save, render, visible_point,
};

/// The picture: 0.5 + 0.5 n, or the sky if a ray meets nothing.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| match visible_point(&OBJECTS, ray) {
        Some(point) => 0.5 + 0.5 * point.n,
        None => direction_colour(ray),
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
