//! The starting point for the exercises of step 5. It draws step 5's own picture.

use glam::DVec3;
use image::RgbImage;
use step05_phong::{
    Camera, Light, Material, Ray, Scene, direction_colour, draw_and_save, phong,
    render, scene, visible_point,
};

/// The colour that `ray` sees: the lit point's, or else the sky's.
fn colour(scene: &Scene<Material, Light>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    phong(&point, ray, scene.ambient_light, &scene.lights).sum()
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
