//! The discriminant, which step 2 computes on the way to the hits but doesn't return.

use step02_sphere::{Ray, Sphere};

/// The discriminant D = b² − 4ac for a sphere and a ray. It's negative if the ray misses, and 0 if
/// it touches the sphere.
pub fn discriminant(sphere: &Sphere, ray: &Ray) -> f64 {
    let (a, b, c) = sphere.coefficients(ray);
    b * b - 4.0 * a * c
}
