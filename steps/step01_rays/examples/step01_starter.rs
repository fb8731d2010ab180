//! The starting point for the exercises of step 1. It draws step 1's own picture.

use glam::DVec3;
use image::RgbImage;
use step01_rays::{Camera, Ray, draw_and_save, render};

/// The colour that `ray` sees, which shows its direction.
fn colour(ray: &Ray) -> DVec3 {
    let v = ray.direction;
    0.7 + 0.3 * DVec3::new(v.x, v.y, -v.z)
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
