use glam::DVec3;
use image::Rgb;

/// The 8-bit colour of an intensity I, round(255 · clamp(I, 0, 1)) in each channel.
pub(crate) fn rgb8(intensity: DVec3) -> Rgb<u8> {
    let rounded = 255.0 * intensity.clamp(DVec3::ZERO, DVec3::ONE) + 0.5;
    Rgb([rounded.x as u8, rounded.y as u8, rounded.z as u8])
}
