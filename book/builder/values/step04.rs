//! The numbers of chapter 4.

use super::Value;
use super::measure::{camera, counted, rgb, short, vector};
use super::pixel::{PIXEL, cool, example, hit, lit, ray, warm};
use glam::DVec3;
use step04_diffuse::{AMBIENT, COOL, Ray, WARM, colour, nearest, picture, scene};

pub const VALUES: &[Value] = &[
    ("step04-ray-direction", || vector(ray().direction)),
    ("step04-t", || short(hit().0)),
    ("step04-p", || vector(warm().point.p)),
    ("step04-p-column", || column(warm().point.p)),
    ("step04-centre", || vector(hit().1.sphere.centre)),
    ("step04-centre-column", || column(hit().1.sphere.centre)),
    ("step04-radius", || short(hit().1.sphere.radius)),
    ("step04-n-column", || column(warm().point.n)),
    ("step04-surface", || vector(hit().1.material.surface.diffuse)),
    ("step04-ambient", || vector(example().ambient)),
    ("step04-warm-l", || vector(warm().l)),
    ("step04-warm-d", || short(warm().d)),
    ("step04-warm-divisor", || short(WARM.attenuation.at(warm().d))),
    ("step04-warm-cosine", || short(warm().cosine)),
    ("step04-warm-diffuse", || vector(warm().diffuse)),
    ("step04-cool-l", || vector(cool().l)),
    ("step04-cool-d", || short(cool().d)),
    ("step04-cool-divisor", || short(COOL.attenuation.at(cool().d))),
    ("step04-cool-cosine", || short(cool().cosine)),
    ("step04-cool-diffuse", || vector(cool().diffuse)),
    ("step04-sum", || vector(example().ambient + example().diffuse)),
    ("step04-pixel", || rgb(picture(&camera(), 1).get_pixel(PIXEL.0, PIXEL.1).0)),
    ("step04-behind-cosine", || short(lit((380, 136), 1).cosine)),
    ("step04-peach", || short(blueness(WARM.diffuse))),
    ("step04-orange", || format!("{:.2}", blueness(plaster((380, 136))))),
    ("step04-clipped", || {
        let scene = scene();
        let is_seen = |ray: &Ray| nearest(&scene.objects, ray).is_some();
        let is_lit = |ray: &Ray| 1.0 < colour(&scene, ray).max_element();
        counted(|ray| (is_seen(ray) && is_lit(ray)).into())
    }),
];

/// How much blue a light has for its red.
fn blueness(light: DVec3) -> f64 {
    light.z / light.x
}

/// The light that the example `plaster` adds up at a pixel, negative cosines and all.
fn plaster(pixel: (u32, u32)) -> DVec3 {
    let lamps = [WARM, COOL].into_iter().enumerate().map(|(k, lamp)| {
        let lit = lit(pixel, k);
        lit.cosine * lamp.diffuse / lamp.attenuation.at(lit.d)
    });
    AMBIENT + lamps.sum::<DVec3>()
}

/// A vector as a column, for a formula.
fn column(vector: DVec3) -> String {
    let rows = vector.to_array().map(short).join(r" \\ ");
    format!(r"\begin{{bmatrix}} {rows} \end{{bmatrix}}")
}
