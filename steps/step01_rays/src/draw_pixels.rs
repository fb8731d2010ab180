use crate::Camera;
use image::{Rgb, RgbImage};
use rayon::prelude::*;

/// Draws a picture of the camera's size, with `pixel(i, j)` in column i and row j.
/// All processors share the work: each takes a row, and comes back for another.
pub fn draw_pixels(
    camera: &Camera,
    pixel: impl Fn(f64, f64) -> Rgb<u8> + Sync,
) -> RgbImage {
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    image.enumerate_rows_mut().par_bridge().for_each(|(_, row)| {
        for (i, j, rgb) in row {
            *rgb = pixel(i.into(), j.into());
        }
    });
    image
}
