use crate::{Camera, Ray, draw_pixels, rgb8};
use glam::DVec3;
use image::RgbImage;

/// Splits a pixel into `samples` × `samples` sub-pixels. Returns the offset of each
/// sub-pixel's centre from the pixel's centre, (right, down), row by row.
/// # Panics
/// If `samples` is 0, since a pixel without a ray has no colour.
pub fn sub_pixel_offsets(samples: u32) -> Vec<(f64, f64)> {
    assert!(samples > 0, "a pixel needs a ray");
    // With 1 sample, the only offset is 0. With 2, they are −0.25 and 0.25.
    let offset = |k| (f64::from(k) + 0.5) / f64::from(samples) - 0.5;
    let mut offsets = vec![];
    for row in 0..samples {
        for column in 0..samples {
            offsets.push((offset(column), offset(row)));
        }
    }
    offsets
}

/// The mean of `colour(u, v)` over all the offsets (u, v).
pub fn mean_colour(
    offsets: &[(f64, f64)],
    colour: impl Fn(f64, f64) -> DVec3,
) -> DVec3 {
    let sum: DVec3 = offsets.iter().map(|&(u, v)| colour(u, v)).sum();
    sum / offsets.len() as f64
}

/// Draws a picture. Each pixel is split into `samples` × `samples` sub-pixels, and
/// gets the mean of the colours that the rays through their centres see.
/// ```
/// let camera = step01_rays::Camera::new(4, 3, 1.0);
/// let red = step01_rays::render(&camera, 1, |_ray| glam::DVec3::X);
/// assert_eq!(red.get_pixel(3, 2).0, [255, 0, 0]);
/// ```
pub fn render(
    camera: &Camera,
    samples: u32,
    colour: impl Fn(&Ray) -> DVec3 + Sync,
) -> RgbImage {
    let offsets = sub_pixel_offsets(samples);
    draw_pixels(camera, |i, j| {
        let mean = mean_colour(&offsets, |u, v| colour(&camera.ray(i + u, j + v)));
        rgb8(mean)
    })
}
