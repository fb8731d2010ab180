use crate::Camera;
use image::{Rgb, RgbImage};
use rayon::prelude::*;

/// Draws a picture of the camera's size, with `pixel(i, j)` in column i and row j.
/// All processors draw at once, each a row at a time.
pub fn draw_pixels(
    camera: &Camera,
    pixel: &(dyn Fn(f64, f64) -> Rgb<u8> + Sync),
) -> RgbImage {
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    let rows = image.par_chunks_exact_mut(3 * camera.h_res as usize);
    rows.enumerate().for_each(|(j, row)| {
        for (i, bytes) in row.chunks_exact_mut(3).enumerate() {
            bytes.copy_from_slice(&pixel(i as f64, j as f64).0);
        }
    });
    image
}
