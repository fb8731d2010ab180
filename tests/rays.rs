use exercises::camera;
use glam::DVec3;
use proptest::prelude::*;
use step01_rays::Ray;
use step02_sphere::Sphere;

/// The rays through all pixels of the camera.
pub fn rays_of_camera() -> impl Iterator<Item = Ray> {
    let pixels = (0..360).flat_map(|j| (0..640).map(move |i| (i, j)));
    pixels.map(|(i, j)| camera().ray(i.into(), j.into()))
}

/// Points within 10 of the origin along each axis.
pub fn point() -> impl Strategy<Value = DVec3> {
    (-10.0..10.0, -10.0..10.0, -10.0..10.0)
        .prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

/// Unit vectors.
pub fn unit() -> impl Strategy<Value = DVec3> {
    let long = point().prop_filter("too short", |v| 0.1 < v.length());
    long.prop_map(|v| v.normalize())
}

/// Spheres of radius 0.1 to 4 around such points.
pub fn sphere() -> impl Strategy<Value = Sphere> {
    (point(), 0.1..4.0).prop_map(|(centre, radius)| Sphere { centre, radius })
}

/// Rays of any length from such points; about half of them aim at the sphere that
/// comes with them.
pub fn rays() -> impl Strategy<Value = (Sphere, Ray)> {
    (sphere(), point(), unit(), 0.1..5.0, 0.0..2.0).prop_map(aim)
}

fn aim(
    (sphere, start, way, length, off): (Sphere, DVec3, DVec3, f64, f64),
) -> (Sphere, Ray) {
    let target = sphere.centre + off * sphere.radius * way;
    (sphere, Ray { start, direction: (target - start).normalize_or(way) * length })
}
