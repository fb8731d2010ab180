use glam::DVec3;
use proptest::prelude::*;
use step02_sphere::{Ray, Sphere};

/// Points within 10 of the origin along each axis.
pub fn random_point() -> impl Strategy<Value = DVec3> {
    (-10.0..10.0, -10.0..10.0, -10.0..10.0).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

/// Vectors of length 1.
pub fn random_unit_vector() -> impl Strategy<Value = DVec3> {
    let vector = random_point().prop_filter("too short", |v| 0.1 < v.length());
    vector.prop_map(|v| v.normalize())
}

/// Spheres of radius 0.1 to 4 around a random point.
pub fn random_sphere() -> impl Strategy<Value = Sphere> {
    (random_point(), 0.1..4.0).prop_map(|(centre, radius)| Sphere { centre, radius })
}

/// Spheres, each with a ray of any length from a random point; about half of the rays hit
/// their sphere.
pub fn random_sphere_and_ray() -> impl Strategy<Value = (Sphere, Ray)> {
    let start = random_point();
    (random_sphere(), start, random_unit_vector(), 0.1..5.0, 0.0..2.0).prop_map(
        |(sphere, start, unit_vector, length, radii)| {
            let target: DVec3 = sphere.centre + radii * sphere.radius * unit_vector;
            let direction = (target - start).normalize_or(unit_vector) * length;
            (sphere, Ray { start, direction })
        },
    )
}
