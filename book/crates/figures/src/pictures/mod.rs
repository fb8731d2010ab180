//! The live pictures, each drawn by its step or example.

mod mirror;
mod pixel_trace;
pub mod step01;
mod step02;
pub mod step03;
mod step04;
mod step05;

use crate::{Live, Output};
use step05_phong::{Camera, Light, Material, Scene, colour, render};

/// The picture of each step, and the mirrors.
pub fn all() -> [Live; 6] {
    [
        step01::picture(),
        step02::picture(),
        step03::picture(),
        step04::picture(),
        step05::picture(),
        mirror::picture(),
    ]
}

/// The name that the chapters give an object: a sphere is called by its colour.
pub fn short_name(name: &str) -> &str {
    name.trim_end_matches(" sphere")
}

/// The picture of a scene of step 5, one ray a pixel.
pub fn render_scene(camera: &Camera, scene: &Scene<Material, Light>) -> Output {
    Output::Picture(render(camera, 1, |ray| colour(scene, ray)))
}
