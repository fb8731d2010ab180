//! The numbers of chapter 2.

use super::rays::{
    camera, count_rays, discriminant, first_hit, length_in_pixels, pixel_ray, unit_ray,
};
use super::{Functions, Values};
use figures::{format_count, format_fixed, format_number, format_vector};
use glam::{DVec2, DVec3};
use step02_sphere::{Ray, Roots, SPHERE, Sphere, quadratic};

pub const VALUES: &Values = &[
    ("step02-point", || format_vector(hit_point())),
    ("step02-long", || format_number(pixel_ray(PIXEL).direction.length())),
    ("step02-distance", || format_number(hit_point().length())),
    ("step02-rays", || format_count(count_rays(|_| true))),
    ("step02-touches", || format_count(count_rays(|ray| discriminant(&SPHERE, ray) == 0.0))),
    ("step02-edge", || format_number(image_radius())),
    ("step02-edge-pixels", || format_fixed(length_in_pixels(image_radius()), 1)),
    ("step02-fifth-pixels", || format_fixed(length_in_pixels(0.2), 1)),
    ("step02-rim-radius", || format_fixed(SPHERE.radius * rim_share().sqrt(), 2)),
    ("step02-rim-depth", || format_number(SPHERE.centre.length() * rim_share())),
    ("step02-rim-narrower", || format_fixed(100.0 - 100.0 * rim_share().sqrt(), 0)),
    ("step02-rim-nearer", || format_fixed(100.0 - 100.0 * rim_share(), 0)),
    ("step02-columns", || {
        format_count((0..camera().h_res).filter(|&i| has_hit(&pixel_ray([i, 180]))).count())
    }),
    ("step02-without-a", || {
        format_count(count_rays(|ray| {
            let (_, b, c) = SPHERE.coefficients(ray);
            quadratic(1.0, b, c) != Roots::Zero
        }))
    }),
    ("step02-normalised", || {
        format_count(count_rays(|ray| has_hit(ray) != has_hit(&unit_ray(ray))))
    }),
    ("step02-edge-misses", || format_count(count_edge_rays(|d| d < 0.0))),
    ("step02-edge-touches", || format_count(count_edge_rays(|d| d == 0.0))),
    ("step02-edge-crosses", || format_count(count_edge_rays(|d| 0.0 < d))),
];

pub const FUNCTIONS: &Functions = &[
    ("axis-b", |z| format_number(SPHERE.coefficients(&axis_ray(z)).1)),
    ("axis-c", |z| format_number(SPHERE.coefficients(&axis_ray(z)).2)),
    ("axis-D", |z| format_number(discriminant(&SPHERE, &axis_ray(z)))),
    ("axis-near", |z| format_number(axis_roots(z).0)),
    ("axis-far", |z| format_number(axis_roots(z).1)),
];

/// The pixel of the worked example.
const PIXEL: [u32; 2] = [300, 150];

/// A ray along −z that starts at (0, 0, z).
fn axis_ray(z: f64) -> Ray {
    Ray { start: z * DVec3::Z, direction: DVec3::NEG_Z }
}

/// The smaller and the larger root of that ray.
fn axis_roots(z: f64) -> (f64, f64) {
    let Roots::Two(near, far) = SPHERE.intersect(&axis_ray(z)) else {
        unreachable!("the axis meets the sphere")
    };
    (near, far)
}

/// The point where the ray of the worked example meets the sphere.
fn hit_point() -> DVec3 {
    let ray = pixel_ray(PIXEL);
    ray.at(first_hit(&SPHERE, &ray))
}

fn has_hit(ray: &Ray) -> bool {
    SPHERE.intersect(ray).first_hit().is_some()
}

/// The radius of the sphere's image on the image plane.
fn image_radius() -> f64 {
    (1.0_f64 / 24.0).sqrt()
}

/// How near the tangent points are, as a share of the distance of the centre: the square of the
/// cosine between them.
fn rim_share() -> f64 {
    1.0 - SPHERE.radius * SPHERE.radius / SPHERE.centre.length_squared()
}

/// The number of those of 360 rays of whose discriminant the predicate holds; in real
/// numbers, each ray touches the sphere of radius 1 at (1, 2, −5).
fn count_edge_rays(predicate: impl Fn(f64) -> bool) -> usize {
    let sphere = Sphere { centre: DVec3::new(1.0, 2.0, -5.0), radius: 1.0 };
    let axis = sphere.centre.normalize();
    let (u, v) = axis.any_orthonormal_pair();
    let (sin, cos) = (1.0 / sphere.centre.length()).asin().sin_cos();
    let discriminants = (0..360).map(|degrees| {
        let side = DVec2::from_angle(f64::from(degrees).to_radians());
        let direction = cos * axis + sin * (side.x * u + side.y * v);
        discriminant(&sphere, &Ray { start: DVec3::ZERO, direction })
    });
    discriminants.filter(|d| predicate(*d)).count()
}
