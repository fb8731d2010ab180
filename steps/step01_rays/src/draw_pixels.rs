use crate::Camera;
use image::{Rgb, RgbImage};
use rayon::prelude::*;

/// Draws a picture of the camera's size, with `pixel(i, j)` in column i and row j.
/// All processors share the rows, so several of them call `pixel` at the same time.
pub fn draw_pixels(
    camera: &Camera,
    pixel: impl Fn(f64, f64) -> Rgb<u8> + Sync,
) -> RgbImage {
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    let rows = image.enumerate_rows_mut();
    // Each row comes with its number, which isn't needed: each pixel of the row
    // comes with its own i and j.
    rows.par_bridge().for_each(|(_, row)| {
        for (i, j, rgb) in row {
            *rgb = pixel(f64::from(i), f64::from(j));
        }
    });
    image
}
