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
    // Each pixel of a row knows its i and j, so the number of the row isn't needed.
    rows.par_bridge().for_each(|(_, row)| {
        for (i, j, rgb) in row {
            *rgb = pixel(f64::from(i), f64::from(j));
        }
    });
    image
}
