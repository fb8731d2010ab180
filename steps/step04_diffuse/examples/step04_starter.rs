//! The starting point for the exercises of step 4. It draws step 4's own picture.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{
    Camera, Matte, PointLight, Ray, Scene, ambient, diffuse_at, direction_colour,
    draw_and_save, render, scene, visible_point,
};

/// The colour that `ray` sees: the lit point's, or else the sky's.
fn colour(scene: &Scene<Matte, PointLight>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut intensity = ambient(point.material(), scene.ambient_light);
    for light in &scene.lights {
        intensity += diffuse_at(point.p, point.n, point.material(), light);
    }
    intensity
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
