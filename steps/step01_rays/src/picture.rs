use crate::{Camera, direction_colour, render};
use image::RgbImage;

/// The picture of step 1: the direction of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, direction_colour)
}
