//! The numbers of chapter 5 that are not in the trace of a pixel.

use super::rays::{camera, half_angle, object_of_pixel, pixel_ray};
use super::{Functions, Values};
use course::{Difference, ungated_colour};
use figures::{format_count, format_fixed, format_number};
use std::sync::LazyLock;
use step05_phong::{COOL, picture, reflect, render, scene, visible_point};

pub const VALUES: &Values = &[
    ("step05-v-length", || format_number(pixel_ray(PIXEL).direction.length())),
    ("step05-cool-angle", || {
        let (objects, ray) = (scene().objects, pixel_ray(PIXEL));
        let point = visible_point(&objects, &ray).expect("an object");
        let (l, _) = COOL.direction_from(point.p);
        format_fixed(reflect(point.n, l).angle_between(-ray.direction).to_degrees(), 1)
    }),
    ("step05-r-s", || format_number(object_of_pixel(PIXEL).material.specular.x)),
    ("step05-gate-pixels", || format_count(UNGATED.0)),
    ("step05-gate-most", || format_count(UNGATED.1.into())),
    ("step05-teal-v-length", || format_number(pixel_ray(TEAL).direction.length())),
    ("step05-teal-power", || {
        let shininess = object_of_pixel(TEAL).material.shininess;
        format_number(pixel_ray(TEAL).direction.length().powi(shininess))
    }),
    ("step05-check-r-s", || {
        let objects = (1..).zip(scene().objects);
        format_number(objects.map(|(k, o)| f64::from(k) * o.material.specular.x).sum())
    }),
    ("step05-check-n", || {
        let objects = (1..).zip(scene().objects);
        format_number(objects.map(|(k, o)| f64::from(k * o.material.shininess)).sum())
    }),
];

pub const FUNCTIONS: &Functions =
    &[("half-angle", |n| format_fixed(half_angle(n).to_degrees(), 1))];

/// The pixel of the worked example.
const PIXEL: [u32; 2] = [470, 120];

/// A pixel in the highlight of the teal sphere.
const TEAL: [u32; 2] = [583, 215];

/// The number of pixels that change without the test of n·l, and the largest change of a
/// byte.
static UNGATED: LazyLock<(usize, u8)> = LazyLock::new(|| {
    let scene = scene();
    let ungated = render(&camera(), 1, |ray| ungated_colour(&scene, ray));
    match Difference::between(&picture(&camera(), 1), &ungated) {
        Some(Difference::Pixels { count, largest, .. }) => (count, largest),
        _ => (0, 0),
    }
});
