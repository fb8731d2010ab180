//! The numbers of chapter 3.

use super::Values;
use super::rays::{camera, count_rays, length_in_pixels, pixel_ray, sum_over_rays};
use figures::{format_count, format_fixed, format_number};
use glam::DVec3;
use step02_sphere::Roots;
use step03_nearest::{OBJECTS, Object, Ray, Sphere, nearest};

pub const VALUES: &Values = &[
    ("step03-tests", || format_count(sum_over_rays(|_| OBJECTS.len()))),
    ("step03-hits", || format_count(sum_over_rays(|ray| first_hits(ray).count()))),
    ("step03-last", || format_count(count_rays(|ray| first_hits(ray).last() != nearest_hit(ray)))),
    ("step03-behind", || format_count(count_rays(|ray| line_meets(ray, &OBJECTS[4])))),
    ("step03-meets", || {
        let ray = pixel_ray([195, 237]);
        format_count(OBJECTS.iter().filter(|object| line_meets(&ray, object)).count())
    }),
    ("step03-gap", || {
        let ground = OBJECTS[1].sphere;
        let gaps = [0, 2, 3, 5, 6, 7].map(|k| {
            let Sphere { centre, radius } = OBJECTS[k].sphere;
            (centre.distance(ground.centre) - ground.radius - radius).abs()
        });
        format_number(gaps.into_iter().fold(0.0, f64::max))
    }),
    ("step03-horizon", || {
        let Sphere { centre, radius } = OBJECTS[1].sphere;
        format_fixed((centre.length_squared() - radius * radius).sqrt(), 1)
    }),
    ("step03-long", || format_fixed(oval(&OBJECTS[6])[0], 2)),
    ("step03-wide", || format_fixed(oval(&OBJECTS[6])[1], 2)),
    ("step03-red-long", || format_fixed(oval(&OBJECTS[0])[0], 2)),
    ("step03-red-wide", || format_fixed(oval(&OBJECTS[0])[1], 2)),
    ("step03-eye", || format_fixed(-0.5 / camera().matrix.z_axis.x, 2)),
];

/// The first hit of a ray with each object, and its t, in the order of the list.
fn first_hits(ray: &Ray) -> impl Iterator<Item = (&'static str, f64)> {
    OBJECTS
        .iter()
        .filter_map(|object| Some((object.name, object.sphere.intersect(ray).first_hit()?)))
}

/// The nearest of the hits.
fn nearest_hit(ray: &Ray) -> Option<(&'static str, f64)> {
    nearest(&OBJECTS, ray).map(|hit| (hit.object.name, hit.t))
}

/// Whether the line of a ray, with the part behind the eye, meets an object.
fn line_meets(ray: &Ray, object: &Object<DVec3>) -> bool {
    object.sphere.intersect(ray) != Roots::Zero
}

/// The length and the width, in pixels, of the oval in which the image plane cuts the cone of rays
/// that touch an object.
fn oval(object: &Object<DVec3>) -> [f64; 2] {
    let Sphere { centre, radius } = object.sphere;
    let (to_axis, to_side) =
        (DVec3::NEG_Z.angle_between(centre), (radius / centre.length()).asin());
    let length = (to_axis + to_side).tan() - (to_axis - to_side).tan();
    let width = 2.0 * to_side.sin() / (to_axis.cos().powi(2) - to_side.sin().powi(2)).sqrt();
    [length, width].map(length_in_pixels)
}
