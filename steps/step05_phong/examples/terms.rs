//! The scene, drawn with one term of its light at a time.

use glam::DVec3;
use image::{ImageResult, RgbImage};
use step05_phong::{Camera, Terms, direction_colour, render, scene, terms};

/// The scene, drawn with only one term of the sum, which `term` picks.
pub fn picture(camera: &Camera, term: fn(Terms) -> DVec3) -> RgbImage {
    let scene = scene();
    render(camera, 1, |ray| match terms(&scene, ray) {
        Some(terms) => term(terms),
        None => direction_colour(ray),
    })
}

fn main() -> ImageResult<()> {
    let camera = Camera::new(640, 360, 60_f64.to_radians());
    picture(&camera, |terms| terms.ambient).save("ambient.png")?;
    picture(&camera, |terms| terms.diffuse).save("diffuse.png")?;
    picture(&camera, |terms| terms.specular).save("specular.png")
}
