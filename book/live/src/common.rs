use step02_sphere::{Camera, Ray, Roots, Sphere};

/// The camera of the course's pictures: 640 columns, 16:9, 60 degrees, which the programs
/// turn into radians; π/3 is another number in its last digit.
pub fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

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
