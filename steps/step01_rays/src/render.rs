use crate::{Camera, Ray, colour::rgb8};
use glam::DVec3;
use image::RgbImage;
use rayon::iter::{ParallelBridge, ParallelIterator};
use std::sync::atomic::{AtomicU32, Ordering};

/// How many rows are drawn so far, for a program that tells how long it will take.
pub(crate) static ROWS: AtomicU32 = AtomicU32::new(0);

/// Draws the picture in which each pixel has the mean `colour` of the rays through it.
///
/// Each pixel is a grid of `samples` × `samples` sub-pixels, with a ray through the
/// centre of each. All processors draw at once, a row each.
pub fn render(
    camera: &Camera,
    samples: u32,
    colour: impl Fn(&Ray) -> DVec3 + Sync,
) -> RgbImage {
    let side = f64::from(samples);
    let centre = |k: u32| (f64::from(k) + 0.5) / side - 0.5;
    let offsets: Vec<f64> = (0..samples).map(centre).collect();
    let weight = 1.0 / (side * side);
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    image.rows_mut().enumerate().par_bridge().for_each(|(j, row)| {
        let camera = *camera;
        for (i, pixel) in row.enumerate() {
            let mut sum = DVec3::ZERO;
            for v in &offsets {
                for u in &offsets {
                    sum += colour(&camera.ray(i as f64 + u, j as f64 + v));
                }
            }
            *pixel = rgb8(sum * weight);
        }
        ROWS.fetch_add(1, Ordering::Relaxed);
    });
    image
}
