use step02_sphere::{Ray, Sphere};

/// b² − 4ac of a ray and a sphere.
pub fn discriminant(sphere: &Sphere, ray: &Ray) -> f64 {
    let (a, b, c) = sphere.coefficients(ray);
    b * b - 4.0 * a * c
}
