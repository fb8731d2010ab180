//! The live pictures, each drawn by its step or example.

mod mirror;
mod pixel_trace;
pub mod step01;
mod step02;
pub mod step03;
mod step04;
mod step05;

use crate::{Live, Output};
use step05_phong::{Camera, Light, Material, Scene};
#[cfg(not(target_arch = "wasm32"))]
use step05_phong::{colour, render};

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

/// The picture of a scene of step 5, one ray a pixel. In a page, the example `fast` draws
/// it, as a dragged picture has to follow; the tests compare it with `colour`.
pub fn render_scene(camera: &Camera, scene: &Scene<Material, Light>) -> Output {
    #[cfg(target_arch = "wasm32")]
    let picture = exercises::fast::draw(fearless_simd::Level::new(), camera, 1, scene);
    #[cfg(not(target_arch = "wasm32"))]
    let picture = render(camera, 1, |ray| colour(scene, ray));
    Output::Picture(picture)
}
