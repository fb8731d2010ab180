//! The numbers of what comes after the steps, and of the exercises that look ahead.

use super::rays::{camera, sum_over_rays};
use super::{Functions, Values};
use course::examples::{crowd::crowd, gamma::srgb, look_at::look_at};
use figures::{format_count, format_fixed, format_number, format_vector};
use glam::{DMat3, DVec3};
use step02_sphere::Roots;
use step04_diffuse::{Camera, OBJECTS, Object, Ray};

pub const VALUES: &Values = &[
    ("next-basis-x", || format_vector(look_at_basis().x_axis)),
    ("next-basis-y", || format_vector(look_at_basis().y_axis)),
    ("next-basis-z", || format_vector(look_at_basis().z_axis)),
    ("crowd-objects", || format_count(crowd().objects.len())),
    ("crowd-marbles", || format_count(crowd().objects.len() - OBJECTS.len())),
    ("next-critical", || format_fixed((1.0_f64 / 1.5).asin().to_degrees(), 0)),
    ("next-tests-many", || format_count(sum_over_rays(|_| 1000))),
    ("next-wasted", || {
        let tests = sum_over_rays(|_| OBJECTS.len()) as f64;
        format_fixed(100.0 * (1.0 - sum_over_rays(count_met_spheres) as f64 / tests), 0)
    }),
    ("next-half-byte", || format_number(decode_srgb(128.0 / 255.0))),
    ("next-byte-of-half", || format_fixed(255.0 * srgb(0.5), 0)),
];

pub const FUNCTIONS: &Functions = &[("mirror-depth", |k| format_count(mirror_depth(k)))];

/// The number of mirrors in a row, each of which leaves the share k, after which less than
/// one step of 8 bits is left.
fn mirror_depth(k: f64) -> usize {
    let shares = (1..).map(|depth| k.powi(depth));
    1 + shares.take_while(|share| 1.0 / 255.0 <= *share).count()
}

/// The number of spheres that the line of a ray meets.
fn count_met_spheres(ray: &Ray) -> usize {
    let meets = |object: &&Object<_>| object.sphere.intersect(ray) != Roots::Zero;
    OBJECTS.iter().filter(meets).count()
}

/// The basis x', y', z' of a camera at (4, 2, 0) that looks at the middle of the largest
/// sphere, as columns.
fn look_at_basis() -> DMat3 {
    let identity = Camera { matrix: DMat3::IDENTITY, ..camera() };
    let target = OBJECTS[0].sphere.centre;
    look_at(&identity, DVec3::new(4.0, 2.0, 0.0), target, 0.0).matrix
}

/// The share of a screen's light for a share of 255 in sRGB.
fn decode_srgb(x: f64) -> f64 {
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}
