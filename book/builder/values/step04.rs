//! The numbers of chapter 4.

use super::Value;
use super::measure::{PIXEL, camera, counted, number, object, told, vector};
use glam::DVec3;
use step04_diffuse::{
    AMBIENT, COOL, Ray, WARM, colour, nearest, scene, visible_point,
};

pub const VALUES: &[Value] = &[
    ("step04-ray-direction", || at("V")),
    ("step04-t", || at("t")),
    ("step04-p", || at("p")),
    ("step04-p-column", || column(&at("p"))),
    ("step04-centre", || vector(object(PIXEL).sphere.centre)),
    ("step04-centre-column", || column(&vector(object(PIXEL).sphere.centre))),
    ("step04-radius", || number(object(PIXEL).sphere.radius)),
    ("step04-n-column", || column(&at("n"))),
    ("step04-surface", || vector(object(PIXEL).material.matte.diffuse)),
    ("step04-ambient", || at("ambient")),
    ("step04-warm-l", || at("l warm")),
    ("step04-warm-d", || at("d warm")),
    ("step04-warm-divisor", || at("divisor warm")),
    ("step04-warm-cosine", || at("nl warm")),
    ("step04-warm-diffuse", || at("diffuse warm")),
    ("step04-cool-l", || at("l cool")),
    ("step04-cool-d", || at("d cool")),
    ("step04-cool-divisor", || at("divisor cool")),
    ("step04-cool-cosine", || at("nl cool")),
    ("step04-cool-diffuse", || at("diffuse cool")),
    ("step04-sum", || at("sum")),
    ("step04-pixel", || at("bytes")),
    ("step04-behind-cosine", || told("step04_diffuse", BEHIND, "nl cool")),
    ("step04-peach", || number(blueness(WARM.diffuse))),
    ("step04-orange", || format!("{:.2}", blueness(plaster()))),
    ("step04-clipped", || {
        let scene = scene();
        let is_seen = |ray: &Ray| nearest(&scene.objects, ray).is_some();
        let is_lit = |ray: &Ray| 1.0 < colour(&scene, ray).max_element();
        counted(|ray| (is_seen(ray) && is_lit(ray)).into())
    }),
];

/// A number of the pixel of the worked example.
fn at(which: &str) -> String {
    told("step04_diffuse", PIXEL, which)
}

/// A pixel that the cool light is behind.
const BEHIND: [u32; 2] = [380, 136];

/// How much blue a light has for its red.
fn blueness(light: DVec3) -> f64 {
    light.z / light.x
}

/// The light that the example `plaster` adds up there, negative cosines and all.
fn plaster() -> DVec3 {
    let (scene, [i, j]) = (scene(), BEHIND.map(f64::from));
    let point = visible_point(&scene.objects, &camera().ray(i, j));
    let lamps = point.iter().flat_map(|point| {
        [WARM, COOL].map(|lamp| {
            let (l, d) = lamp.direction_from(point.p);
            point.n.dot(l) * lamp.diffuse / lamp.attenuation.divisor(d)
        })
    });
    AMBIENT + lamps.sum::<DVec3>()
}

/// A vector such as (1, 2, 3) as a column, for a formula.
fn column(vector: &str) -> String {
    let rows = vector.trim_matches(['(', ')']).replace(", ", r" \\ ");
    format!(r"\begin{{bmatrix}} {rows} \end{{bmatrix}}")
}
