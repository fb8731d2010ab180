//! Your scene, polished: the snowman in marble, among marbles of glass.

use glam::DVec3;
use image::RgbImage;
use step05_phong::{
    Camera, Light, Material, Object, Scene, Sphere, Surface, colour, render, run,
    scene,
};

/// R_s and n, what makes the same paint look like another material.
type Polish = ([f64; 3], i32);

const STONE: Polish = ([0.4; 3], 10);
const MARBLE: Polish = ([0.6; 3], 60);
const GLASS: Polish = ([1.0; 3], 200);
const GOLD: Polish = ([1.0, 0.75, 0.35], 20);

fn ball(
    centre: [f64; 3],
    radius: f64,
    paint: [f64; 3],
    (specular, shininess): Polish,
) -> Object<Material> {
    let (surface, specular) = (Surface::of(paint.into()), specular.into());
    let material = Material { surface, specular, shininess };
    Object { sphere: Sphere { centre: centre.into(), radius }, material }
}

/// A marble on the ground, where its middle is at x and z.
fn marble(x: f64, z: f64, radius: f64, paint: [f64; 3]) -> Object<Material> {
    let away = DVec3::new(x, 0.0, z + 8.0).length_squared();
    let y = ((40.0 + radius).powi(2) - away).sqrt() - 41.5;
    ball([x, y, z], radius, paint, GLASS)
}

/// The snowman among his marbles, in the light of the step.
pub fn my_scene() -> Scene<Material, Light> {
    let (white, jet) = ([0.72, 0.71, 0.76], [0.05, 0.04, 0.07]);
    let mut objects = vec![
        ball([0.0, -41.5, -8.0], 40.0, [0.30, 0.31, 0.42], STONE), // the ground
        ball([0.0, -0.75, -7.0], 0.95, white, MARBLE), // three balls, once snow
        ball([0.0, 0.55, -7.0], 0.65, white, MARBLE),
        ball([0.0, 1.40, -7.0], 0.44, white, MARBLE),
        ball([0.0, 1.62, -7.1], 0.42, [0.45, 0.30, 0.08], GOLD), // a cap
        ball([0.0, 2.05, -7.1], 0.14, [0.60, 0.05, 0.10], GLASS), // a bobble
        marble(-2.3, -6.4, 0.45, [0.03, 0.10, 0.40]),
        marble(-1.3, -5.4, 0.28, [0.45, 0.03, 0.12]),
        marble(1.5, -5.6, 0.36, [0.02, 0.28, 0.18]),
        marble(2.6, -7.4, 0.60, [0.35, 0.12, 0.42]),
    ];
    let eye = |x| ball([x, 1.46, -6.57], 0.05, jet, GLASS);
    objects.extend([-0.12, 0.16].map(eye));
    let button = |y| ball([0.0, y, -6.37], 0.06, jet, GLASS);
    objects.extend([0.3, 0.55, 0.8].map(button));
    // The carrot is amber now.
    objects.extend((0..9).map(|k| {
        let along = f64::from(k) / 8.0;
        let centre = [0.02 + 0.5 * along, 1.33 - 0.08 * along, -6.54];
        ball(centre, 0.1 - 0.08 * along, [0.75, 0.30, 0.02], GLASS)
    }));
    Scene { objects, ..scene() }
}

/// The picture: your scene in the whole Phong sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = my_scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
