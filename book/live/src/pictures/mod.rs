//! The pictures that answer, each drawn by its step.

mod step01;
mod step05;

pub use step01::STEP01;
pub use step05::{OBJECTS, STEP05};

use crate::Sight;
use glam::{DMat3, DVec3};
use step01_rays::{Camera, Ray, render};

/// What `camera` sees, one ray a pixel.
fn picture(camera: &Camera, colour: impl Fn(&Ray) -> DVec3 + Sync) -> Sight {
    let image = render(camera, 1, colour);
    let mut pixels = vec![255; 4 * image.as_raw().len() / 3];
    for (four, three) in pixels.chunks_exact_mut(4).zip(image.pixels()) {
        four[..3].copy_from_slice(&three.0);
    }
    Sight::Picture { size: image.dimensions().into(), pixels }
}

/// The three bytes of the pixel through which `ray` goes: a picture of this one ray.
fn pixel(ray: &Ray, colour: impl Fn(&Ray) -> DVec3 + Sync) -> [u8; 3] {
    let matrix = DMat3::from_cols(DVec3::ZERO, DVec3::ZERO, ray.direction);
    let camera = Camera { centre: ray.start, h_res: 1, v_res: 1, matrix };
    render(&camera, 1, colour).get_pixel(0, 0).0
}
