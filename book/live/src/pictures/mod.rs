//! The pictures that answer, each drawn by its step.

pub(crate) mod asked;
mod chain;
mod polish;
pub mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

pub use chain::NAMES;
pub use step01::STEP01;
pub use step02::STEP02;
pub use step03::STEP03;
pub use step04::STEP04;
pub use step05::STEP05;

use crate::Sight;
use glam::DVec3;
use image::RgbImage;
use step05_phong::{Camera, Light, Material, Ray, Scene, render};

/// What `camera` sees, one ray a pixel.
pub(crate) fn picture(
    camera: &Camera,
    colour: impl Fn(&Ray) -> DVec3 + Sync,
) -> Sight {
    shown(&render(camera, 1, colour))
}

/// What `camera` sees of a scene of step 5. In a page, the example `fast` draws it, as
/// a dragged picture has to follow; the tests compare what it draws with `colour`.
pub(crate) fn lit(camera: &Camera, scene: &Scene<Material, Light>) -> Sight {
    #[cfg(target_arch = "wasm32")]
    return shown(&exercises::fast::draw(
        fearless_simd::Level::new(),
        camera,
        1,
        scene,
    ));
    #[cfg(not(target_arch = "wasm32"))]
    picture(camera, |ray| step05_phong::colour(scene, ray))
}

/// An image, to be seen in a page.
fn shown(image: &RgbImage) -> Sight {
    Sight::Picture { size: image.dimensions().into(), pixels: rgba(image) }
}

/// Red, green, blue and 255 for each pixel, row by row, as a page draws them.
pub fn rgba(image: &RgbImage) -> Vec<u8> {
    let mut pixels = vec![255; 4 * image.as_raw().len() / 3];
    for (four, three) in pixels.chunks_exact_mut(4).zip(image.pixels()) {
        four[..3].copy_from_slice(&three.0);
    }
    pixels
}
