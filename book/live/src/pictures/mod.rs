//! The pictures that answer, each drawn by its step.

mod numbers;
pub mod pixel;
pub mod step01;
mod step02;
pub mod step03;
mod step04;
mod step05;

use crate::{Live, Sight};
use step05_phong::{Camera, Light, Material, Object, Ray, Scene, nearest};
#[cfg(not(target_arch = "wasm32"))]
use step05_phong::{colour, render};

/// Every picture that shows a step.
pub fn all() -> [Live; 5] {
    [
        step01::picture(),
        step02::picture(),
        step03::picture(),
        step04::picture(),
        step05::picture(),
    ]
}

/// The name that the chapters give an object: a sphere is called by its colour.
pub fn short_name(name: &str) -> &str {
    name.trim_end_matches(" sphere")
}

/// What `camera` sees of a scene of step 5, one ray a pixel. In a page, the example
/// `fast` draws it, as a dragged picture has to follow; the tests compare what it draws
/// with `colour`.
pub fn shaded(camera: &Camera, scene: &Scene<Material, Light>) -> Sight {
    #[cfg(target_arch = "wasm32")]
    let picture =
        exercises::fast::draw(fearless_simd::Level::new(), camera, 1, scene);
    #[cfg(not(target_arch = "wasm32"))]
    let picture = render(camera, 1, |ray| colour(scene, ray));
    Sight::Picture(picture)
}

/// Which object a ray meets first, and its t.
fn met<M>(objects: &[Object<M>], ray: &Ray) -> Option<(usize, f64)> {
    let hit = nearest(objects, ray)?;
    let k = objects.iter().position(|one| std::ptr::eq(one, hit.object))?;
    Some((k, hit.t))
}
