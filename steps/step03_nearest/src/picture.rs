use crate::{COLOURS, Camera, Ray, SPHERES, direction_colour, nearest, render};
use glam::DVec3;
use image::RgbImage;

/// The colour that `ray` sees: that of the nearest sphere, otherwise its own
/// direction.
pub fn colour(ray: &Ray) -> DVec3 {
    match nearest(&SPHERES, ray) {
        Some(hit) => COLOURS[hit.index],
        None => direction_colour(ray),
    }
}

/// The picture of step 3: the spheres of the scene, each in its flat colour.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}
