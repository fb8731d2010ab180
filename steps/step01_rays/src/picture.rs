use crate::{Camera, Ray, render};
use glam::DVec3;
use image::RgbImage;

/// The direction V of a ray as a colour: red for right, green for up, blue for ahead.
///
/// Each axis maps −1 to 0 and 1 to 1; ahead is −z.
pub fn direction_colour(ray: &Ray) -> DVec3 {
    let v = ray.direction;
    0.7 + 0.3 * DVec3::new(v.x, v.y, -v.z)
}

/// The picture of step 1: the direction of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, direction_colour)
}
