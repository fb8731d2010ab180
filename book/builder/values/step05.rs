//! The numbers of chapter 5.

use super::Value;
use super::measure::{PIXEL, UNGATED, camera, number, object, tenths, told};
use step05_phong::{Material, Object, scene};

pub const VALUES: &[Value] = &[
    ("step05-v", || at("v")),
    ("step05-v-length", || number(length(PIXEL))),
    ("step05-warm-r", || at("r warm")),
    ("step05-warm-alignment", || at("rv warm")),
    ("step05-warm-specular", || at("specular warm")),
    ("step05-cool-r", || at("r cool")),
    ("step05-cool-alignment", || at("rv cool")),
    ("step05-cool-angle", || {
        let cosine: f64 =
            at("rv cool").replace('−', "-").parse().unwrap_or(f64::NAN);
        tenths(cosine.acos().to_degrees())
    }),
    ("step05-cool-power", || at("power cool")),
    ("step05-cool-specular", || at("specular cool")),
    ("step05-shininess", || at("shininess")),
    ("step05-r-s", || number(object(PIXEL).material.specular.x)),
    ("step05-diffuse", || at("diffuse")),
    ("step05-specular", || at("specular")),
    ("step05-sum", || at("sum")),
    ("step05-pixel", || at("bytes")),
    ("step05-half-1", || half_width(1.0)),
    ("step05-half-10", || half_width(10.0)),
    ("step05-half-16", || half_width(16.0)),
    ("step05-half-40", || half_width(40.0)),
    ("step05-half-300", || half_width(300.0)),
    ("step05-gate-pixels", || UNGATED.0.to_string()),
    ("step05-gate-most", || UNGATED.1.to_string()),
    ("step05-edge-cosine", || told("step05_phong", EDGE, "nl cool")),
    ("step05-edge-below", || told("step05_phong", BELOW, "nl cool")),
    ("step05-edge-alignment", || told("step05_phong", EDGE, "rv cool")),
    ("step05-edge-specular", || told("step05_phong", EDGE, "specular cool")),
    ("step05-teal-v-length", || number(length(TEAL))),
    ("step05-teal-specular", || told("step05_phong", TEAL, "specular")),
    ("step05-check-r-s", || {
        let r_s = |(k, object): (usize, &Object<Material>)| {
            (k + 1) as f64 * object.material.specular.x
        };
        number(scene().objects.iter().enumerate().map(r_s).sum())
    }),
    ("step05-check-n", || {
        let n =
            |(k, object): (i32, &Object<Material>)| k * object.material.shininess;
        (1..).zip(&scene().objects).map(n).sum::<i32>().to_string()
    }),
    ("step05-teal-power", || {
        number(length(TEAL).powi(object(TEAL).material.shininess))
    }),
];

/// The last pixel above the edge of a highlight, and the one below it.
const EDGE: [u32; 2] = [605, 165];
const BELOW: [u32; 2] = [605, 166];

/// A pixel in the highlight of the teal sphere.
const TEAL: [u32; 2] = [583, 215];

/// A number of the pixel of the worked example.
fn at(which: &str) -> String {
    told("step05_phong", PIXEL, which)
}

/// The length of V through a pixel.
fn length(pixel: [u32; 2]) -> f64 {
    let [i, j] = pixel.map(f64::from);
    camera().ray(i, j).direction.length()
}

/// The angle in degrees at which cosⁿ is 1/2.
fn half_width(n: f64) -> String {
    tenths(0.5_f64.powf(1.0 / n).acos().to_degrees())
}
