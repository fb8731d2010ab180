use crate::Ray;
use glam::DVec3;

/// The direction of a ray as a pale colour, which is what a ray sees if it meets
/// nothing: the sky. Red grows to the right, and green upwards. Blue grows with −z,
/// which is always 1 for the rays of a camera made by `Camera::new`.
pub fn direction_colour(ray: &Ray) -> DVec3 {
    let v = ray.direction;
    0.7 + 0.3 * DVec3::new(v.x, v.y, -v.z)
}
