//! Better samples: one ray through a random point of each sub-pixel.

use glam::DVec3;
use image::RgbImage;
use step01_rays::{
    Camera, Ray, direction_colour, draw_and_save, draw_pixels, mean_colour, rgb8,
    sub_pixel_offsets,
};

/// Two numbers from 0 to 1 that look random, but depend only on `x` and `y`.
pub fn noise(x: u32, y: u32) -> [f64; 2] {
    let mut h = u64::from(x) << 32 | u64::from(y);
    for _ in 0..3 {
        h = (h ^ h >> 32).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
    [h >> 32, h & 0xffff_ffff].map(|half| half as f64 / 2_f64.powi(32))
}

/// The ray through a random point of the sub-pixel whose centre is at (i, j). A
/// pixel has `side` × `side` sub-pixels.
pub fn jittered(camera: &Camera, side: u32, i: f64, j: f64) -> Ray {
    let side = f64::from(side);
    // Column and row of the sub-pixel, counted over the whole picture.
    let (x, y) = ((i + 0.5) * side, (j + 0.5) * side);
    let [u, v] = noise(x as u32, y as u32);
    camera.ray(i + (u - 0.5) / side, j + (v - 0.5) / side)
}

/// The colour that `ray` sees: rings around the middle, finer towards the edges.
fn colour(ray: &Ray) -> DVec3 {
    let v = ray.direction;
    let rings = 2800.0 * (v.x * v.x + v.y * v.y);
    direction_colour(ray) * if rings.fract() < 0.5 { 1.0 } else { 0.4 }
}

/// The picture: rays on a grid in the left half, and random rays in the right half;
/// at least 4×4 per pixel.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let side = samples.max(4);
    let centres = sub_pixel_offsets(side);
    draw_pixels(camera, |i, j| {
        rgb8(mean_colour(&centres, |u, v| {
            let (i, j) = (i + u, j + v);
            let ray = camera.ray(i, j);
            let is_left = ray.direction.x < 0.0;
            colour(&if is_left { ray } else { jittered(camera, side, i, j) })
        }))
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
