//! Rings that show how long each ray's V is.

use glam::DVec3;
use image::RgbImage;
use step01_rays::{Camera, Ray, direction_colour, draw_and_save, render};

/// The number of rings over which the length of V grows by 1.
const RINGS: f64 = 50.0;

/// The colour that `ray` sees: the colour of its direction, halved in every other
/// ring.
fn colour(ray: &Ray) -> DVec3 {
    let is_bright = (RINGS * ray.direction.length()).fract() < 0.5;
    let light = if is_bright { 1.0 } else { 0.5 };
    light * direction_colour(ray)
}

/// The picture: the sky of step 1 in rings.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
