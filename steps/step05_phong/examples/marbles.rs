//! Your scene, polished: the snowman in marble, among marbles of glass.

#[path = "../../step03_nearest/examples/my_scene.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod my_scene;

use glam::DVec3;
use image::RgbImage;
use my_scene::{ball, objects};
use step05_phong::{
    Camera, Light, Material, Matte, Object, Scene, colour, draw_and_save, render,
    scene,
};

/// R_s and n. They make the same paint look like a different material.
type Polish = ([f64; 3], i32);

const STONE: Polish = ([0.4; 3], 10);
const MARBLE: Polish = ([0.6; 3], 60);
const GLASS: Polish = ([1.0; 3], 200);
const GOLD: Polish = ([1.0, 0.75, 0.35], 20);

/// The object in this paint, polished.
fn polished(
    object: Object<DVec3>,
    paint: [f64; 3],
    (specular, shininess): Polish,
) -> Object<Material> {
    let (matte, specular) = (Matte::of(paint.into()), specular.into());
    object.with_material(Material { matte, specular, shininess })
}

/// A part of the snowman in its new material, which depends on the part's name. The
/// carrot is amber now.
fn repainted(part: Object<DVec3>) -> Object<Material> {
    match part.name {
        "ground" => polished(part, [0.30, 0.31, 0.42], STONE),
        "belly" | "chest" | "head" => polished(part, [0.72, 0.71, 0.76], MARBLE),
        "cap" => polished(part, [0.45, 0.30, 0.08], GOLD),
        "bobble" => polished(part, [0.60, 0.05, 0.10], GLASS),
        "carrot" => polished(part, [0.75, 0.30, 0.02], GLASS),
        _ => polished(part, [0.05, 0.04, 0.07], GLASS),
    }
}

/// A marble on the ground, whose centre has this x and z.
fn marble(x: f64, z: f64, radius: f64, paint: [f64; 3]) -> Object<Material> {
    let away = DVec3::new(x, 0.0, z + 8.0).length_squared();
    let y = ((40.0 + radius).powi(2) - away).sqrt() - 41.5;
    polished(ball("marble", [x, y, z], radius, paint), paint, GLASS)
}

/// The snowman among his marbles, in the light of the step.
pub fn my_scene() -> Scene<Material, Light> {
    let mut objects: Vec<_> = objects().into_iter().map(repainted).collect();
    objects.extend([
        marble(-2.3, -6.4, 0.45, [0.03, 0.10, 0.40]),
        marble(-1.3, -5.4, 0.28, [0.45, 0.03, 0.12]),
        marble(1.5, -5.6, 0.36, [0.02, 0.28, 0.18]),
        marble(2.6, -7.4, 0.60, [0.35, 0.12, 0.42]),
    ]);
    Scene { objects, ..scene() }
}

/// The picture: your scene, lit by the whole Phong sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = my_scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
