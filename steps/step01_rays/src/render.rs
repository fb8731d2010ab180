use crate::{Camera, Ray, rgb8};
use glam::DVec3;
use image::RgbImage;
use rayon::iter::{ParallelBridge, ParallelIterator};

/// Draws the picture in which each pixel has the mean `colour` of the rays through it.
///
/// Each pixel is a grid of `samples` × `samples` sub-pixels, with a ray through the
/// centre of each. All processors draw at once, a row each.
/// ```
/// let camera = step01_rays::Camera::new(4, 3, 1.0);
/// let red = step01_rays::render(&camera, 1, |_ray| glam::DVec3::X);
/// assert_eq!(red.get_pixel(3, 2).0, [255, 0, 0]);
/// ```
/// # Panics
/// Where `samples` is 0: a pixel without a ray has no colour.
pub fn render(
    camera: &Camera,
    samples: u32,
    colour: impl Fn(&Ray) -> DVec3 + Sync,
) -> RgbImage {
    assert!(0 < samples, "a pixel needs a ray");
    let side = f64::from(samples);
    let offset = |k: u32| (f64::from(k) + 0.5) / side - 0.5;
    let offsets: Vec<f64> = (0..samples).map(offset).collect();
    let mut image = RgbImage::new(camera.h_res, camera.v_res);
    image.enumerate_rows_mut().par_bridge().for_each(|(_, row)| {
        for (i, j, pixel) in row {
            let mut sum = DVec3::ZERO;
            for v in &offsets {
                for u in &offsets {
                    sum += colour(&camera.ray(f64::from(i) + u, f64::from(j) + v));
                }
            }
            *pixel = rgb8(sum / (side * side));
        }
    });
    image
}
