//! The numbers of what comes after the steps, and of the exercises that look ahead.

use super::Value;
use super::measure::{camera, count, counted, number, vector};
use exercises::{gamma::srgb, look_at::look_at};
use glam::{DMat3, DVec3};
use step02_sphere::Roots;
use step04_diffuse::{
    Camera, OBJECTS, Object, PointLight, Ray, scene, visible_point,
};

pub const VALUES: &[Value] = &[
    ("next-basis-x", || vector(basis().x_axis)),
    ("next-basis-y", || vector(basis().y_axis)),
    ("next-basis-z", || vector(basis().z_axis)),
    ("next-depth-9", || depth(0.9)),
    ("next-depth-5", || depth(0.5)),
    ("next-critical", || format!("{:.0}", (1.0_f64 / 1.5).asin().to_degrees())),
    ("next-tests", || counted(|_| OBJECTS.len())),
    ("next-tests-many", || counted(|_| 1000)),
    ("next-roots", || counted(roots)),
    ("next-wasted", || {
        let asked = count(|_| OBJECTS.len()) as f64;
        format!("{:.0}", 100.0 * (1.0 - count(roots) as f64 / asked))
    }),
    ("next-lamps", || counted(|ray| lamps(ray).len())),
    ("next-lamps-in-front", || {
        counted(|ray| lamps(ray).into_iter().filter(|cosine| 0.0 < *cosine).count())
    }),
    ("next-half-byte", || number(light_of_byte(128.0))),
    ("next-byte-of-half", || format!("{:.0}", 255.0 * srgb(0.5))),
];

/// How many mirrors that reflect this part leave less than one step of 8 bits.
fn depth(part: f64) -> String {
    let left = |count: &i32| part.powi(*count) < 1.0 / 255.0;
    (1..).find(left).map_or("none".to_string(), |count| count.to_string())
}

/// How many spheres of the scene the line of a ray meets.
fn roots(ray: &Ray) -> usize {
    let meets = |object: &&Object<_>| object.sphere.intersect(ray) != Roots::Zero;
    OBJECTS.iter().filter(meets).count()
}

/// The cosine between n and l for each lamp, at the point that a ray sees.
fn lamps(ray: &Ray) -> Vec<f64> {
    let scene = scene();
    let Some(point) = visible_point(&scene.objects, ray) else { return vec![] };
    let cosine = |light: &PointLight| point.n.dot(light.direction_from(point.p).0);
    scene.lights.iter().map(cosine).collect()
}

/// The basis x', y', z' of a camera at (4, 2, 0) that looks at the middle of the
/// largest sphere, as columns.
fn basis() -> DMat3 {
    let own = Camera { matrix: DMat3::IDENTITY, ..camera() };
    let target = OBJECTS[0].sphere.centre;
    look_at(&own, DVec3::new(4.0, 2.0, 0.0), target, 0.0).matrix
}

/// The part of a screen's light that a byte of sRGB stands for.
fn light_of_byte(byte: f64) -> f64 {
    let x = byte / 255.0;
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}
