//! The last picture: a crowd of marbles around the spheres of the scene, seen from above.

#[path = "mirror.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod mirror;

use glam::{DMat3, DVec3};
use image::RgbImage;
use mirror::{Mirror, colour, mirrors};
use step05_phong::{Camera, Light, Object, Scene, Sphere, render, run};

/// The scene of the mirrors, and on its ground as many marbles as find room.
pub fn crowd() -> Scene<Mirror, Light> {
    let mut scene = mirrors();
    let ground = scene.objects[1].sphere;
    for k in 1..320 {
        // A sunflower: each seed is a golden angle further round, and a little further out.
        let (angle, away) = (2.399_963 * f64::from(k), 0.55 * f64::from(k).sqrt());
        let radius = [0.2, 0.26, 0.32, 0.4][k as usize % 4];
        let flat = DVec3::new(away * angle.cos(), 0.0, away * angle.sin() - 6.5);
        let Some(centre) = on_top(&ground, flat, radius) else { continue };
        let marble = Sphere { centre, radius };
        if scene.objects.iter().all(|object| !overlap(&object.sphere, &marble)) {
            let material = material(k as usize, &scene);
            scene.objects.push(Object { sphere: marble, material });
        }
    }
    scene
}

/// The centre of a ball of this radius that lies on `ground` above or below a place.
fn on_top(ground: &Sphere, place: DVec3, radius: f64) -> Option<DVec3> {
    let side = (place - ground.centre).with_y(0.0);
    let up = (ground.radius + radius).powi(2) - side.length_squared();
    (0.0 < up).then(|| place.with_y(ground.centre.y + up.sqrt()))
}

fn overlap(one: &Sphere, other: &Sphere) -> bool {
    one.centre.distance(other.centre) < one.radius + other.radius - 1e-6
}

/// Each marble has the material of one of the scene's spheres; every fifth is a mirror.
fn material(k: usize, scene: &Scene<Mirror, Light>) -> Mirror {
    let of = [0, 2, 3, 5, 7, 8][k % 6];
    let material = scene.objects[of].material.material;
    let k = if k % 5 == 0 { 0.8 } else { 0.12 };
    Mirror { material, k }
}

/// The camera of the course, lifted and tilted.
fn from_above(camera: &Camera) -> Camera {
    let tilt = DMat3::from_rotation_x(-0.3);
    Camera {
        centre: DVec3::new(0.0, 2.2, 0.8),
        matrix: tilt * camera.matrix,
        ..*camera
    }
}

/// The picture: a ray may meet ten mirrors, one after the other.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = crowd();
    render(&from_above(camera), samples, |ray| colour(&scene, ray, 10))
}

fn main() {
    run(env!("CARGO_CRATE_NAME"), picture);
}
