use crate::{Camera, Ray, draw_pixels, rgb8};
use glam::DVec3;
use image::RgbImage;

/// The centres of `samples` × `samples` sub-pixels, row by row: how far each is to the
/// right of the pixel's own centre, and how far below.
/// # Panics
/// Where `samples` is 0: a pixel without a ray has no colour.
pub fn sub_pixels(samples: u32) -> Vec<(f64, f64)> {
    assert!(0 < samples, "a pixel needs a ray");
    let side = f64::from(samples);
    let offset = |k: u32| (f64::from(k) + 0.5) / side - 0.5;
    let place = |k: u32| (offset(k % samples), offset(k / samples));
    (0..samples * samples).map(place).collect()
}

/// The mean of `colour(u, v)` over all (u, v) of a list like that of `sub_pixels`.
pub fn mean(places: &[(f64, f64)], colour: impl Fn(f64, f64) -> DVec3) -> DVec3 {
    let sum: DVec3 = places.iter().map(|&(u, v)| colour(u, v)).sum();
    sum / places.len() as f64
}

/// Draws the picture in which each pixel has the mean `colour` of the rays through it,
/// one through the centre of each of its `samples` × `samples` sub-pixels.
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
    let centres = sub_pixels(samples);
    draw_pixels(camera, &|i, j| {
        rgb8(mean(&centres, |u, v| colour(&camera.ray(i + u, j + v))))
    })
}
