//! The starting point for the exercises of step 2. It draws step 2's own picture.

use glam::DVec3;
use image::RgbImage;
use step02_sphere::{Camera, Ray, Sphere, direction_colour, draw_and_save, render};

/// The one sphere.
const SPHERE: Sphere = Sphere::new([0.0, 0.0, -5.0], 1.0);

/// The colour that `ray` sees: red for the sphere, or else the sky.
fn colour(sphere: &Sphere, ray: &Ray) -> DVec3 {
    match sphere.intersect(ray).first_hit() {
        Some(_) => DVec3::new(0.91, 0.34, 0.28),
        None => direction_colour(ray),
    }
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&SPHERE, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
