use glam::DVec3;
use image::Rgb;

/// The 8-bit colour of an intensity I, round(255 · clamp(I, 0, 1)) in each channel.
pub fn rgb8(intensity: DVec3) -> Rgb<u8> {
    // 0.5 more in each channel, since `as` cuts off the fraction. What is below 0 or
    // above 255, `as` turns into 0 or 255.
    Rgb((255.0 * intensity + 0.5).to_array().map(|channel| channel as u8))
}
