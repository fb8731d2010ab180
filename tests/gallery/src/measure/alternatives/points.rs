use super::{Alternative, part, vectors};
use crate::section::{NORMAL, RAY};
use step03_nearest::objects;
use step04_diffuse::normal;

pub(super) const ALL: &[Alternative] = &[
    part(RAY, "r(t) goes backwards, S − tV: p is −p, for the minus", |p| {
        p.point = |ray, t| ray.start - t * ray.direction
    }),
    part(
        RAY,
        "r(t) is S + t V/|V|: a t that counts lengths of V is taken for a distance",
        |p| p.point = |ray, t| ray.start + t * ray.direction.normalize(),
    ),
    part(RAY, "r(t) has lost its t: p is S + V", |p| {
        p.point = |ray, _| ray.start + ray.direction
    }),
    part(NORMAL, "p is r(2t)", |p| p.point = |ray, t| ray.at(2.0 * t)),
    part(NORMAL, "p is r(t/2)", |p| p.point = |ray, t| ray.at(0.5 * t)),
    part(NORMAL, "p is r(t − 1)", |p| p.point = |ray, t| ray.at(t - 1.0)),
    part(NORMAL, "p is r(t + 1)", |p| p.point = |ray, t| ray.at(t + 1.0)),
    part(NORMAL, "p + centre stands for p − centre in n", |p| {
        p.normal = |sphere, p| (p + sphere.centre) / sphere.radius
    }),
    part(NORMAL, "p + centre, normalised, stands for p − centre in n", |p| {
        p.normal = |sphere, p| (p + sphere.centre).normalize()
    }),
    part(NORMAL, "n is divided by r²", |p| {
        p.normal = |sphere, p| normal(sphere, p) / sphere.radius
    }),
    part(NORMAL, "n is multiplied by r, not divided", |p| {
        p.normal = |sphere, p| normal(sphere, p) * sphere.radius * sphere.radius
    }),
    part(NORMAL, "n is the direction of the centre", |p| {
        p.normal = |sphere, _| sphere.centre.normalize()
    }),
    part(NORMAL, "n is p − centre / r, without the parentheses", |p| {
        p.normal = |sphere, p| p - sphere.centre / sphere.radius
    }),
    part(NORMAL, "n is p", |p| p.normal = |_, p| p),
    part(NORMAL, "n is p / r, without the centre", |p| {
        p.normal = |sphere, p| p / sphere.radius
    }),
    part(NORMAL, "n is (centre − p) / r and not normalised", |p| {
        p.normal = |sphere, p| sphere.centre - p
    }),
    part(
        NORMAL,
        "n is that of the first object, the red sphere, everywhere",
        |p| p.normal = |_, p| normal(&objects()[0].sphere, p),
    ),
    part(
        NORMAL,
        "n is that of the last object, the cream sphere, everywhere",
        |p| p.normal = |_, p| normal(&objects()[8].sphere, p),
    ),
    vectors(NORMAL, "n is that of V, not of p", 0, |v| {
        // n = (p − centre) / r is known, so the centre is p − r n; V takes the place of p.
        v.n += (v.ray.direction - v.p) / radius(v);
    }),
    vectors(NORMAL, "p and n change places", 0, |v| (v.p, v.n) = (v.n, v.p)),
    part(
        NORMAL,
        "all points have the material of the first object, the red sphere",
        |p| {
            let first = p.scene.objects[0].material.material;
            p.materials().for_each(|m| *m = first);
        },
    ),
    part(
        NORMAL,
        "all points have the material of the last object, the cream sphere",
        |p| {
            let last = p.scene.objects[8].material.material;
            p.materials().for_each(|m| *m = last);
        },
    ),
];

/// The radius of the sphere on which a point and its normal lie.
fn radius(v: &super::Vectors) -> f64 {
    let is_it = |s: &step02_sphere::Sphere| normal(s, v.p).abs_diff_eq(v.n, 1e-6);
    let all = objects().map(|object| object.sphere);
    all.iter().find(|s| is_it(s)).map_or(1.0, |s| s.radius)
}
