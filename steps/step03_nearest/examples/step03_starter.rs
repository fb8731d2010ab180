//! The starting point for the exercises of step 3. It draws step 3's own picture.

use glam::DVec3;
use image::RgbImage;
use step03_nearest::{
    Camera, OBJECTS, Object, Ray, direction_colour, draw_and_save, nearest, render,
};

/// The colour that `ray` sees: the nearest object's, or else the sky's.
fn colour(objects: &[Object<DVec3>], ray: &Ray) -> DVec3 {
    match nearest(objects, ray) {
        Some(hit) => hit.object.material,
        None => direction_colour(ray),
    }
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&OBJECTS, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
