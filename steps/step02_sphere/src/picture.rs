use crate::{Camera, Ray, Sphere, direction_colour, render};
use glam::DVec3;
use image::RgbImage;

/// The one sphere of this step.
pub const SPHERE: Sphere = Sphere::new([0.0, 0.0, -5.0], 1.0);

/// The colour that `ray` sees: red if it meets `sphere`, or else that of the sky.
pub fn colour(sphere: &Sphere, ray: &Ray) -> DVec3 {
    match sphere.intersect(ray).first_hit() {
        Some(_) => DVec3::new(0.91, 0.34, 0.28),
        None => direction_colour(ray),
    }
}

/// The picture of step 2: one sphere in front of the directions of step 1.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&SPHERE, ray))
}
