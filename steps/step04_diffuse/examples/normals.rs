//! Where the surfaces of the scene face, as a colour.

use image::RgbImage;
use step04_diffuse::{Camera, direction_colour, objects, render, run, seen};

/// The picture: 0.5 + 0.5 n, or the sky where a ray sees no point.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let objects = objects();
    render(camera, samples, |ray| match seen(&objects, ray) {
        Some(point) => 0.5 + 0.5 * point.n,
        None => direction_colour(ray),
    })
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
