//! Computes the discriminant of a sphere and a ray. Step 2 needs it to find the hits, but doesn't
//! return it.

use step02_sphere::{Ray, Sphere};

/// The discriminant D = b² − 4ac for a sphere and a ray. It's negative if the ray misses the
/// sphere, and 0 if the ray touches it.
pub fn discriminant(sphere: &Sphere, ray: &Ray) -> f64 {
    let (a, b, c) = sphere.coefficients(ray);
    b * b - 4.0 * a * c
}
