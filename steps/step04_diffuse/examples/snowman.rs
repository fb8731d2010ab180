//! The snowman of step 3 at sunset, with a lantern: matt surfaces, and two lights.

use glam::DVec3;
use image::RgbImage;
use step04_diffuse::{
    Attenuation, Camera, Object, PointLight, Scene, Sphere, Surface, colour,
    render, run,
};

fn ball(centre: [f64; 3], radius: f64, colour: [f64; 3]) -> Object<Surface> {
    let sphere = Sphere { centre: centre.into(), radius };
    Object { sphere, material: Surface::of(colour.into()) }
}

/// The objects: a ground of snow, and a snowman on it.
fn objects() -> Vec<Object<Surface>> {
    let (coal, wool) = ([0.22, 0.20, 0.27], [0.91, 0.34, 0.28]);
    let mut objects = vec![
        ball([0.0, -41.5, -8.0], 40.0, [0.87, 0.89, 0.96]), // the ground
        ball([0.0, -0.75, -7.0], 0.95, [0.94, 0.95, 0.99]), // three balls of snow
        ball([0.0, 0.55, -7.0], 0.65, [0.97, 0.98, 1.00]),
        ball([0.0, 1.40, -7.0], 0.44, [1.00, 1.00, 1.00]),
        ball([0.0, 1.62, -7.1], 0.42, wool), // a cap, and its bobble
        ball([0.0, 2.05, -7.1], 0.14, [0.99, 0.76, 0.32]),
        ball([-0.12, 1.46, -6.57], 0.05, coal), // two eyes
        ball([0.16, 1.46, -6.57], 0.05, coal),
    ];
    // Three buttons, one above the other.
    objects.extend([0.3, 0.55, 0.8].map(|y| ball([0.0, y, -6.37], 0.06, coal)));
    // A carrot for a nose: nine balls, each smaller than the last and further out.
    objects.extend((0..9).map(|k| {
        let along = f64::from(k) / 8.0;
        let centre = [0.02 + 0.5 * along, 1.33 - 0.08 * along, -6.54];
        ball(centre, 0.1 - 0.08 * along, [0.96, 0.55, 0.20])
    }));
    // A lantern: its colour is beyond white, so that it glows in any light.
    objects.push(ball([1.5, -1.2, -5.6], 0.2, [6.0, 4.5, 2.0]));
    objects
}

/// The scene: the objects, the light of the sky, a low sun, and the lantern's light.
pub fn scene() -> Scene<Surface, PointLight> {
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
    let ambient_light = DVec3::new(0.22, 0.24, 0.40);
    Scene { objects: objects(), ambient_light, lights: vec![sun, lantern] }
}

/// The picture: your scene, in the light of this step.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
