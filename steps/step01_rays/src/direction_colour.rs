use crate::Ray;
use glam::DVec3;

/// The direction of a ray as a pale colour, which is what a ray sees if it meets
/// nothing: the sky. Red grows to the right, green upwards, and blue with −z. A ray
/// of `Camera::new` always has a z of −1, so all of its pictures have a blue of 1.
pub fn direction_colour(ray: &Ray) -> DVec3 {
    let v = ray.direction;
    0.7 + 0.3 * DVec3::new(v.x, v.y, -v.z)
}
