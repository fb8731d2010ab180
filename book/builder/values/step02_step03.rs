//! The numbers of chapters 2 and 3.

use super::{Value, grouped, short, vector};
use crate::worked::{self, camera};
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_3;
use step01_rays::Ray;
use step02_sphere::{Roots, SPHERE, Sphere, quadratic};
use step03_nearest::{SPHERES, nearest};

pub(super) const VALUES: &[Value] = &[
    ("step02-axis-a", || short(on_axis().x)),
    ("step02-axis-b", || short(on_axis().y)),
    ("step02-axis-c", || short(on_axis().z)),
    ("step02-axis-d", || short(discriminant(on_axis()))),
    ("step02-axis-near", || short(both(&SPHERE, &along_axis()).0)),
    ("step02-axis-far", || short(both(&SPHERE, &along_axis()).1)),
    ("step02-v-x", || short(pixel().direction.x)),
    ("step02-v-y", || short(pixel().direction.y)),
    ("step02-far", || short(both(&SPHERE, &pixel()).1)),
    ("step02-point", || vector(pixel().at(both(&SPHERE, &pixel()).0))),
    ("step02-long", || short(pixel().direction.length())),
    ("step02-distance", || short(pixel().at(both(&SPHERE, &pixel()).0).length())),
    ("step02-rays", || count(|_| 1)),
    ("step02-misses", || count_d(|d| d < 0.0)),
    ("step02-touches", || count_d(|d| d == 0.0)),
    ("step02-crosses", || count_d(|d| 0.0 < d)),
    ("step02-edge", || short((1.0_f64 / 24.0).sqrt())),
    ("step02-edge-pixels", || {
        format!("{:.1}", (1.0_f64 / 24.0).sqrt() / camera().matrix.x_axis.x)
    }),
    ("step02-fifth-pixels", || format!("{:.1}", 0.2 / camera().matrix.x_axis.x)),
    ("step02-rim-radius", || format!("{:.2}", rim().0)),
    ("step02-rim-depth", || short(rim().1)),
    ("step02-columns", || {
        let shows = |i: &u32| {
            let ray = camera().ray((*i).into(), 180.0);
            SPHERE.intersect(&ray) != Roots::None
        };
        (0..640).filter(shows).count().to_string()
    }),
    ("step02-without-a", || {
        count(|ray| {
            let (_, b, c) = SPHERE.coefficients(ray);
            usize::from(quadratic(1.0, b, c) != Roots::None)
        })
    }),
    ("step02-normalised", || {
        count(|ray| {
            let unit = Ray { direction: ray.direction.normalize(), ..*ray };
            let hits = [ray, &unit].map(|ray| SPHERE.intersect(ray).first_hit());
            usize::from(hits[0].is_some() != hits[1].is_some())
        })
    }),
    ("step02-edge-misses", || edge_rays(|d| d < 0.0).to_string()),
    ("step02-edge-touches", || edge_rays(|d| d == 0.0).to_string()),
    ("step02-edge-crosses", || edge_rays(|d| 0.0 < d).to_string()),
    ("step03-tests", || count(|_| SPHERES.len())),
    ("step03-hits", || count(|ray| all_hits(ray).count())),
    ("step03-wins", || count(|ray| all_hits(ray).count().min(1))),
    ("step03-last", || {
        count(|ray| wrong(ray, all_hits(ray).last().map(|(index, _)| index)))
    }),
    ("step03-first", || {
        count(|ray| wrong(ray, all_hits(ray).next().map(|(index, _)| index)))
    }),
    ("step03-ties", || {
        count(|ray| {
            let t = nearest(&SPHERES, ray).map(|hit| hit.t);
            all_hits(ray).filter(|hit| Some(hit.1) == t).count().saturating_sub(1)
        })
    }),
    ("step03-behind", || {
        count(|ray| (SPHERES[4].intersect(ray) != Roots::None).into())
    }),
    ("step03-red", || roots(0)),
    ("step03-ground", || roots(1)),
    ("step03-blue", || roots(3)),
    ("step03-green", || roots(4)),
    ("step03-meets", || {
        let met = |s: &&Sphere| s.intersect(&crowded()) != Roots::None;
        SPHERES.iter().filter(met).count().to_string()
    }),
    ("step03-nearest", || {
        nearest(&SPHERES, &crowded()).map_or("none".to_string(), |hit| short(hit.t))
    }),
    ("step03-gap", || {
        let gap = |s: &Sphere| {
            let apart = s.centre.distance(SPHERES[1].centre);
            (apart - SPHERES[1].radius - s.radius).abs()
        };
        let gaps = [0, 2, 3, 5, 6, 7].map(|index| gap(&SPHERES[index]));
        short(gaps.into_iter().fold(0.0, f64::max))
    }),
    ("step03-edge-left", || ground_row(0.0)),
    ("step03-edge-middle", || ground_row(320.0)),
    ("step03-phi", || format!("{:.1}", cone(6).0.to_degrees())),
    ("step03-alpha", || format!("{:.1}", cone(6).1.to_degrees())),
    ("step03-inner", || {
        let (phi, alpha) = cone(6);
        pixels(phi.tan() - (phi - alpha).tan())
    }),
    ("step03-outer", || {
        let (phi, alpha) = cone(6);
        pixels((phi + alpha).tan() - phi.tan())
    }),
    ("step03-long", || pixels(oval(6).0)),
    ("step03-wide", || pixels(oval(6).1)),
    ("step03-red-long", || pixels(oval(0).0)),
    ("step03-red-wide", || pixels(oval(0).1)),
    ("step03-eye", || format!("{:.2}", 0.5 / (FRAC_PI_3 / 2.0).tan())),
];

/// The ray of step 2's worked example, through the pixel in column 300, row 150.
fn pixel() -> Ray {
    camera().ray(300.0, 150.0)
}

/// The ray from the origin along −z.
fn along_axis() -> Ray {
    Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z }
}

/// a, b and c for it and the sphere of step 2.
fn on_axis() -> DVec3 {
    SPHERE.coefficients(&along_axis()).into()
}

/// The radius of the circle in which the rays that touch the sphere of step 2 do so,
/// and its distance from the eye.
fn rim() -> (f64, f64) {
    let Sphere { centre, radius } = SPHERE;
    let square_of_cosine = 1.0 - radius * radius / centre.length_squared();
    (radius * square_of_cosine.sqrt(), centre.length() * square_of_cosine)
}

/// How many of 360 rays around the sphere of radius 1 at (1, 2, −5) have a D that
/// `is_so` holds for.
///
/// In real numbers every one of them touches it.
fn edge_rays(is_so: impl Fn(f64) -> bool) -> usize {
    let sphere = Sphere { centre: DVec3::new(1.0, 2.0, -5.0), radius: 1.0 };
    let axis = sphere.centre.normalize();
    let (u, v) = axis.any_orthonormal_pair();
    let (sin, cos) = (1.0 / sphere.centre.length()).asin().sin_cos();
    let d = |k: &u32| {
        let way = DVec2::from_angle(f64::from(*k).to_radians());
        let direction = cos * axis + sin * (way.x * u + way.y * v);
        let ray = Ray { start: DVec3::ZERO, direction };
        discriminant(sphere.coefficients(&ray).into())
    };
    (0..360).filter(|k| is_so(d(k))).count()
}

fn discriminant(DVec3 { x: a, y: b, z: c }: DVec3) -> f64 {
    b * b - 4.0 * a * c
}

/// Both roots, the same twice where the ray touches, NaN where it misses.
fn both(sphere: &Sphere, ray: &Ray) -> (f64, f64) {
    match sphere.intersect(ray) {
        Roots::None => (f64::NAN, f64::NAN),
        Roots::One(t) => (t, t),
        Roots::Two(near, far) => (near, far),
    }
}

/// The sum of `number` over all rays of the course's pictures, with commas.
fn count(number: impl Fn(&Ray) -> usize + Sync) -> String {
    grouped(worked::count(number) as f64)
}

/// How many of those rays have a discriminant, for the sphere of step 2, that
/// `is_so` holds for.
fn count_d(is_so: impl Fn(f64) -> bool + Sync) -> String {
    count(|ray| is_so(discriminant(SPHERE.coefficients(ray).into())).into())
}

/// The index and t of every sphere of the scene that `ray` meets, in their order.
fn all_hits(ray: &Ray) -> impl Iterator<Item = (usize, f64)> {
    let spheres = SPHERES.iter().enumerate();
    spheres.filter_map(|(k, s)| Some((k, s.intersect(ray).first_hit()?)))
}

/// 1 where `index` is not the nearest sphere, otherwise 0.
fn wrong(ray: &Ray, index: Option<usize>) -> usize {
    usize::from(index != nearest(&SPHERES, ray).map(|hit| hit.index))
}

/// The ray of step 3's worked example, through the pixel in column 195, row 237.
fn crowded() -> Ray {
    camera().ray(195.0, 237.0)
}

/// Both t of a sphere of the scene along that ray.
fn roots(index: usize) -> String {
    let (near, far) = both(&SPHERES[index], &crowded());
    format!("{} and {}", short(near), short(far))
}

/// The first row in which a column of the picture would show the ground, were it
/// alone.
fn ground_row(column: f64) -> String {
    let shows = |j: &u32| {
        let ray = camera().ray(column, (*j).into());
        SPHERES[1].intersect(&ray).first_hit().is_some()
    };
    (0..360).find(shows).map_or("none".to_string(), |j| j.to_string())
}

/// The angles of the cone of rays that touch a sphere of the scene: φ from −z to its
/// axis, and α from its axis to its side.
fn cone(index: usize) -> (f64, f64) {
    let Sphere { centre, radius } = SPHERES[index];
    (DVec3::NEG_Z.angle_between(centre), (radius / centre.length()).asin())
}

/// How long and how wide the oval is in which that cone cuts the image plane.
fn oval(index: usize) -> (f64, f64) {
    let (phi, alpha) = cone(index);
    let long = (phi + alpha).tan() - (phi - alpha).tan();
    let root = (phi.cos().powi(2) - alpha.sin().powi(2)).sqrt();
    (long, 2.0 * alpha.sin() / root)
}

/// A length on the image plane in pixels.
fn pixels(length: f64) -> String {
    format!("{:.2}", length / camera().matrix.x_axis.x)
}
