//! The scene of step 4 in the light of a low sun instead of its warm light.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{
    COOL_LIGHT, Camera, Matte, PointLight, Ray, Scene, ambient, diffuse_at,
    direction_colour, draw_and_save, render, scene, visible_point,
};

/// A light so far away that its direction and brightness are the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// The direction to it, of any length except 0.
    pub direction: DVec3,
    /// L_d, its intensity in red, green and blue; 0 or more.
    pub diffuse: DVec3,
}

/// The sun in the picture.
pub const SUN: Sun = Sun {
    direction: DVec3::new(-4.0, 2.0, 1.0),
    diffuse: DVec3::new(1.0, 0.84, 0.64),
};

impl Sun {
    /// I_d = R_d · max(n·l, 0) · L_d: l is the same everywhere, and there is no d.
    pub fn diffuse(&self, n: DVec3, material: &Matte) -> DVec3 {
        let l = self.direction.normalize();
        material.diffuse * l.dot(n).max(0.0) * self.diffuse
    }
}

/// The colour that `ray` sees.
fn colour(scene: &Scene<Matte, PointLight>, sun: &Sun, ray: &Ray) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let mut intensity = ambient(point.material(), scene.ambient_light);
    intensity += sun.diffuse(point.n, point.material());
    for light in &scene.lights {
        intensity += diffuse_at(point.p, point.n, point.material(), light);
    }
    intensity
}

/// The picture: the sun replaces the warm light, and the cool light stays.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = Scene { lights: vec![COOL_LIGHT], ..scene() };
    render(camera, samples, |ray| colour(&scene, &SUN, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
