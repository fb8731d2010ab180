//! Computes the discriminant of a sphere and a ray. Step 2 computes the same discriminant to find
//! the hits, but doesn't return it.

use step02_sphere::{Ray, Sphere};

/// The discriminant D = b² − 4ac for a sphere and a ray. D is negative if the ray's line misses the
/// sphere, and 0 if the line touches the sphere.
pub fn discriminant(sphere: &Sphere, ray: &Ray) -> f64 {
    let (a, b, c) = sphere.coefficients(ray);
    b * b - 4.0 * a * c
}
