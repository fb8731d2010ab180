//! The last picture: a crowd of marbles around the scene's spheres, from above.

#[path = "mirror.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod mirror;

use glam::{DMat3, DVec3};
use image::RgbImage;
use mirror::{Mirror, OFFSET, colour, mirrors};
use step05_phong::{Camera, Light, Object, Scene, Sphere, draw_and_save, render};

/// The centre of a ball of this radius that lies on `ground`, at the x and z of
/// `place`, or None if the ground does not reach that far.
fn on_top(ground: &Sphere, place: DVec3, radius: f64) -> Option<DVec3> {
    let aside = (place - ground.centre).with_y(0.0);
    let squared = (ground.radius + radius).powi(2) - aside.length_squared();
    (squared > 0.0).then(|| place.with_y(ground.centre.y + squared.sqrt()))
}

/// Whether two balls overlap. Two that only touch don't: the 1e-6 allows for
/// rounding.
fn overlap(one: &Sphere, other: &Sphere) -> bool {
    one.centre.distance(other.centre) < one.radius + other.radius - 1e-6
}

/// The material of the marble with this number: one of the scene's materials, but
/// not that of the ground, the white sphere or the green sphere. Every fifth marble
/// is a good mirror.
fn material(number: usize, scene: &Scene<Mirror, Light>) -> Mirror {
    let painted = [0, 2, 3, 5, 7, 8][number % 6];
    let material = scene.objects[painted].material.material;
    Mirror { material, k: if number.is_multiple_of(5) { 0.8 } else { 0.12 } }
}

/// The scene of the mirrors, with a marble at each of 599 places on its ground that
/// is still free.
pub fn crowd() -> Scene<Mirror, Light> {
    let mut scene = mirrors();
    let ground = scene.objects[1].sphere;
    for number in 1..600 {
        let (angle, away) = (2.4 * number as f64, 0.33 * (number as f64).sqrt());
        let place = DVec3::new(away * angle.cos(), 0.0, away * angle.sin() - 7.5);
        let radius = [0.19, 0.25, 0.3, 0.38][number % 4];
        let Some(centre) = on_top(&ground, place, radius) else { continue };
        let marble = Sphere { centre, radius };
        if !scene.objects.iter().any(|object| overlap(&object.sphere, &marble)) {
            let material = material(number, &scene);
            scene.objects.push(Object { name: "marble", sphere: marble, material });
        }
    }
    scene
}

/// The picture, with the camera lifted and tilted.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = crowd();
    let centre = DVec3::new(0.0, 2.4, 1.0);
    let matrix = DMat3::from_rotation_x(-0.28) * camera.matrix;
    let camera = Camera { centre, matrix, ..*camera };
    render(&camera, samples, |ray| colour(&scene, ray, 10, OFFSET))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
