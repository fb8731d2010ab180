//! Where the exercises of step 4 begin: step 4's own picture.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{
    Camera, Matte, PointLight, Ray, Scene, ambient, diffuse, direction_colour,
    render, run, scene, visible_point,
};

/// The colour that `ray` sees: the lit point, or else its own direction.
fn colour(scene: &Scene<Matte, PointLight>, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut intensity = ambient(point.material, scene.ambient_light);
    for light in &scene.lights {
        let (l, d) = light.direction_from(point.p);
        intensity += diffuse(point.n, l, d, point.material, light);
    }
    intensity
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
