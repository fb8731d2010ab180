//! The picture of step 4, its intensities encoded with the sRGB curve.

use glam::DVec3;
use image::{Rgb, RgbImage};
use step04_diffuse::{
    Camera, colour, draw_and_save, draw_pixels, mean_colour, scene,
    sub_pixel_offsets,
};

/// The sRGB value of a linear intensity I, both from 0 to 1: a straight line near
/// black, and a power above that.
pub fn srgb(i: f64) -> f64 {
    if i <= 0.0031308 { 12.92 * i } else { 1.055 * i.powf(1.0 / 2.4) - 0.055 }
}

/// The 8-bit colour of an intensity: clamped first, then encoded, then rounded.
pub fn rgb8(intensity: DVec3) -> Rgb<u8> {
    let encoded = intensity.clamp(DVec3::ZERO, DVec3::ONE).map(srgb);
    Rgb((255.0 * encoded + 0.5).to_array().map(|channel| channel as u8))
}

/// The picture that `render` draws, but with the curve applied to each pixel's
/// mean.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    let centres = sub_pixel_offsets(samples);
    draw_pixels(camera, |i, j| {
        let ray = |u, v| camera.ray(i + u, j + v);
        rgb8(mean_colour(&centres, |u, v| colour(&scene, &ray(u, v))))
    })
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
