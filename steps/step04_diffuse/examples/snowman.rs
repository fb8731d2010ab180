//! The snowman of step 3 at sunset, with a lantern: matte materials, and two
//! lights.

#[path = "../../step03_nearest/examples/my_scene.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod my_scene;

use glam::DVec3;
use image::RgbImage;
use my_scene::{ball, objects};
use step04_diffuse::{
    Attenuation, Camera, Matte, PointLight, Scene, colour, draw_and_save, render,
};

/// The scene: the objects, the light of the sky, a low sun, and a lantern.
pub fn scene() -> Scene<Matte, PointLight> {
    let sun = PointLight {
        position: DVec3::new(-60.0, 16.0, 20.0),
        diffuse: DVec3::new(0.95, 0.50, 0.25),
        attenuation: Attenuation { a: 1.0, b: 0.0, c: 0.0 },
    };
    let lantern = PointLight {
        position: DVec3::new(1.5, -1.2, -5.6),
        diffuse: DVec3::new(1.0, 0.72, 0.30),
        attenuation: Attenuation { a: 0.4, b: 0.0, c: 0.5 },
    };
    let mut objects = objects();
    // Its colour is brighter than white, so that it glows in any light.
    objects.push(ball("lantern", lantern.position.into(), 0.2, [6.0, 4.5, 2.0]));
    let matte = objects.iter().map(|o| o.with_material(Matte::of(o.material)));
    Scene {
        objects: matte.collect(),
        ambient_light: DVec3::new(0.22, 0.24, 0.40),
        lights: vec![sun, lantern],
    }
}

/// The picture: your scene, in the light of this step.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
