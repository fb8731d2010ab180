use glam::DVec3;
use image::Rgb;

/// The 8-bit colour of an intensity I, round(255 · clamp(I, 0, 1)) in each channel.
pub fn rgb8(intensity: DVec3) -> Rgb<u8> {
    // `as` cuts off the fraction, so 0.5 is added to round. It also clamps:
    // anything below 0 becomes 0, and anything above 255 becomes 255.
    Rgb((255.0 * intensity + 0.5).to_array().map(|channel| channel as u8))
}
