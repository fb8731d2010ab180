//! The picture of step 4 with a first highlight, where a mirror would show the lamp.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{colour, scene};
use step05_phong::{Camera, WARM, reflect, render, run, visible_point};

/// The picture: white where r is within 10° of the eye, and step 4's colour elsewhere.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    let limit = 10_f64.to_radians().cos();
    render(camera, samples, |ray| {
        if let Some(point) = visible_point(&scene.objects, ray) {
            let (l, _) = WARM.direction_from(point.p);
            let r = reflect(point.n, l);
            let v = -ray.direction.normalize();
            if limit < r.dot(v) {
                return DVec3::ONE;
            }
        }
        colour(&scene, ray)
    })
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
