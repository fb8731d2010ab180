//! The numbers of chapter 4 that are not in the trace of a pixel.

use super::Values;
use super::rays::{object_of_pixel, pixel_ray};
use figures::{format_column, format_fixed, format_number, format_vector};
use glam::DVec3;
use step02_sphere::quadratic;
use step04_diffuse::{AMBIENT, Attenuation, COOL, WARM, scene, visible_point};

pub const VALUES: &Values = &[
    ("step04-p-column", || format_column(point_and_normal(PIXEL).0)),
    ("step04-centre", || format_vector(object_of_pixel(PIXEL).sphere.centre)),
    ("step04-centre-column", || format_column(object_of_pixel(PIXEL).sphere.centre)),
    ("step04-radius", || format_number(object_of_pixel(PIXEL).sphere.radius)),
    ("step04-n-column", || format_column(point_and_normal(PIXEL).1)),
    ("step04-surface", || format_vector(object_of_pixel(PIXEL).material.matte.diffuse)),
    ("step04-warm-a", || format_number(WARM.attenuation.a)),
    ("step04-warm-brighter", || format_number(distance_of_full_light(&WARM.attenuation))),
    ("step04-peach", || format_number(blue_per_red(WARM.diffuse))),
    ("step04-orange", || format_fixed(blue_per_red(plaster_light()), 2)),
];

/// The pixel of the worked example.
const PIXEL: [u32; 2] = [470, 120];

/// The point p that a pixel shows, and its normal n.
fn point_and_normal(pixel: [u32; 2]) -> (DVec3, DVec3) {
    let objects = scene().objects;
    let point = visible_point(&objects, &pixel_ray(pixel)).expect("an object");
    (point.p, point.n)
}

/// The distance at which a light of this attenuation is as bright as its L_d: nearer, it
/// is brighter.
fn distance_of_full_light(attenuation: &Attenuation) -> f64 {
    let Attenuation { a, b, c } = *attenuation;
    quadratic(c, b, a - 1.0).first_hit().expect("it fades")
}

fn blue_per_red(light: DVec3) -> f64 {
    light.z / light.x
}

/// The light that the example `plaster`, negative cosines and all, adds up at a point that
/// the cool light is behind.
fn plaster_light() -> DVec3 {
    let (p, n) = point_and_normal([380, 136]);
    let diffuse = [WARM, COOL].map(|light| {
        let (l, d) = light.direction_from(p);
        n.dot(l) * light.diffuse / light.attenuation.divisor(d)
    });
    AMBIENT + diffuse.into_iter().sum::<DVec3>()
}
