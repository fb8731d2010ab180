//! The numbers of chapter 2.

use super::Value;
use super::measure::{
    ahead, camera, counted, discriminant, number, pixels, tenths, vector,
};
use glam::{DVec2, DVec3};
use step02_sphere::{Ray, Roots, SPHERE, Sphere, quadratic};

pub const VALUES: &[Value] = &[
    ("sphere-a", || number(SPHERE.coefficients(&pixel()).0)),
    ("sphere-b", || number(SPHERE.coefficients(&pixel()).1)),
    ("sphere-c", || number(SPHERE.coefficients(&pixel()).2)),
    ("sphere-discriminant", || number(discriminant(&SPHERE, &pixel()))),
    ("sphere-near", || number(near(&pixel()))),
    ("step02-axis-a", || number(SPHERE.coefficients(&axis()).0)),
    ("step02-axis-b", || number(SPHERE.coefficients(&axis()).1)),
    ("step02-axis-c", || number(SPHERE.coefficients(&axis()).2)),
    ("step02-behind-b", || number(SPHERE.coefficients(&ahead(0.0, -10.0)).1)),
    ("step02-behind-near", || number(near(&ahead(0.0, -10.0)))),
    ("step02-behind-far", || number(far(&ahead(0.0, -10.0)))),
    ("step02-axis-near", || number(near(&axis()))),
    ("step02-axis-far", || number(far(&axis()))),
    ("step02-v-x", || number(pixel().direction.x)),
    ("step02-v-y", || number(pixel().direction.y)),
    ("step02-far", || number(far(&pixel()))),
    ("step02-point", || vector(point())),
    ("step02-long", || number(pixel().direction.length())),
    ("step02-distance", || number(point().length())),
    ("step02-rays", || counted(|_| 1)),
    ("step02-touches", || {
        counted(|ray| (discriminant(&SPHERE, ray) == 0.0).into())
    }),
    ("step02-edge", || number((1.0_f64 / 24.0).sqrt())),
    ("step02-edge-pixels", || tenths(pixels((1.0_f64 / 24.0).sqrt()))),
    ("step02-fifth-pixels", || tenths(pixels(0.2))),
    ("step02-rim-radius", || format!("{:.2}", rim().0)),
    ("step02-rim-depth", || number(rim().1)),
    ("step02-columns", || {
        let shows = |&i: &u32| is_met(&camera().ray(i.into(), 180.0));
        (0..640).filter(shows).count().to_string()
    }),
    ("step02-without-a", || {
        counted(|ray| {
            let (_, b, c) = SPHERE.coefficients(ray);
            (quadratic(1.0, b, c) != Roots::Zero).into()
        })
    }),
    ("step02-normalised", || {
        counted(|ray| {
            let unit = Ray { direction: ray.direction.normalize(), ..*ray };
            (is_met(ray) != is_met(&unit)).into()
        })
    }),
    ("step02-edge-misses", || edge_rays(|d| d < 0.0)),
    ("step02-edge-touches", || edge_rays(|d| d == 0.0)),
    ("step02-edge-crosses", || edge_rays(|d| 0.0 < d)),
];

/// The ray from the origin along −z.
fn axis() -> Ray {
    ahead(0.0, 0.0)
}

/// The ray through the pixel in column 300, row 150.
fn pixel() -> Ray {
    camera().ray(300.0, 150.0)
}

/// The smaller root of `ray` and the sphere.
fn near(ray: &Ray) -> f64 {
    SPHERE.intersect(ray).iter().next().expect("a root")
}

/// The larger root.
fn far(ray: &Ray) -> f64 {
    SPHERE.intersect(ray).iter().last().expect("a root")
}

/// Where it meets the sphere.
fn point() -> DVec3 {
    pixel().at(near(&pixel()))
}

fn is_met(ray: &Ray) -> bool {
    SPHERE.intersect(ray).first_hit().is_some()
}

/// The radius of the circle in which the rays that touch the sphere do so, and its
/// distance from the eye.
fn rim() -> (f64, f64) {
    let Sphere { centre, radius } = SPHERE;
    let square_of_cosine = 1.0 - radius * radius / centre.length_squared();
    (radius * square_of_cosine.sqrt(), centre.length() * square_of_cosine)
}

/// How many of 360 rays around the sphere of radius 1 at (1, 2, −5) have a D that
/// `is_so` holds for.
///
/// In real numbers every one of them touches it.
fn edge_rays(is_so: impl Fn(f64) -> bool) -> String {
    let sphere = Sphere { centre: DVec3::new(1.0, 2.0, -5.0), radius: 1.0 };
    let axis = sphere.centre.normalize();
    let (u, v) = axis.any_orthonormal_pair();
    let (sin, cos) = (1.0 / sphere.centre.length()).asin().sin_cos();
    let ray = |degrees: u32| {
        let side = DVec2::from_angle(f64::from(degrees).to_radians());
        let direction = cos * axis + sin * (side.x * u + side.y * v);
        Ray { start: DVec3::ZERO, direction }
    };
    let is_so = |&degrees: &u32| is_so(discriminant(&sphere, &ray(degrees)));
    (0..360).filter(is_so).count().to_string()
}
