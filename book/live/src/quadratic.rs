use step02_sphere::{Ray, Roots, Sphere};

/// Both t, the same twice where the ray touches, NaN where it misses.
pub fn roots(sphere: &Sphere, ray: &Ray) -> [f64; 2] {
    match sphere.intersect(ray) {
        Roots::None => [f64::NAN; 2],
        Roots::One(t) => [t; 2],
        Roots::Two(near, far) => [near, far],
    }
}

/// b² − 4ac of a ray and a sphere.
pub fn discriminant(sphere: &Sphere, ray: &Ray) -> f64 {
    let (a, b, c) = sphere.coefficients(ray);
    b * b - 4.0 * a * c
}
