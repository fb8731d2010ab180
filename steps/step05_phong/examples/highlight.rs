//! The picture of step 4 with a first highlight, where a mirror would show the
//! lamp.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{colour, scene};
use step05_phong::{
    Camera, WARM_LIGHT, draw_and_save, reflect, render, visible_point,
};

/// The picture: white where r is within 10° of the eye, and step 4's colour
/// elsewhere.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    let limit = 10_f64.to_radians().cos();
    render(camera, samples, |ray| {
        if let Some(point) = visible_point(&scene.objects, ray) {
            let (l, _) = WARM_LIGHT.direction_from(point.p);
            let r = reflect(point.n, l);
            let v = -ray.direction.normalize();
            if r.dot(v) > limit {
                return DVec3::ONE;
            }
        }
        colour(&scene, ray)
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
