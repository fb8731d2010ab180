//! The depth: how far away the nearest hit is, as a shade of grey.

use glam::DVec3;
use image::RgbImage;
use step03_nearest::{
    Camera, OBJECTS, Object, Ray, draw_and_save, nearest, render,
};

/// The distance from the start of `ray` to its nearest hit, t |V|.
pub fn distance(objects: &[Object<DVec3>], ray: &Ray) -> Option<f64> {
    nearest(objects, ray).map(|hit| hit.t * ray.direction.length())
}

/// The colour that `ray` sees: white at a distance of 4, black at 14 or if it hits
/// nothing.
fn colour(objects: &[Object<DVec3>], ray: &Ray) -> DVec3 {
    let (white, black) = (4.0, 14.0);
    let d = distance(objects, ray).unwrap_or(black);
    DVec3::splat((black - d) / (black - white))
}

/// The picture: the scene of step 3, measured.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&OBJECTS, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
