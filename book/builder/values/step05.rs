//! The numbers of chapter 5.

use super::Value;
use super::measure::{UNGATED, camera, rgb, short, tenths, vector};
use super::pixel::{PIXEL, cool, example, hit, lit, ray, warm};
use step05_phong::{Material, Object, picture, scene, terms};

pub const VALUES: &[Value] = &[
    ("step05-v", || vector(warm().v)),
    ("step05-v-length", || short(ray().direction.length())),
    ("step05-warm-r", || vector(warm().r)),
    ("step05-warm-alignment", || short(warm().alignment)),
    ("step05-warm-specular", || vector(warm().specular)),
    ("step05-cool-r", || vector(cool().r)),
    ("step05-cool-alignment", || short(cool().alignment)),
    ("step05-cool-angle", || tenths(cool().alignment.acos().to_degrees())),
    ("step05-cool-power", || {
        short(cool().alignment.powi(hit().1.material.shininess))
    }),
    ("step05-cool-specular", || vector(cool().specular)),
    ("step05-shininess", || hit().1.material.shininess.to_string()),
    ("step05-r-s", || short(hit().1.material.specular.x)),
    ("step05-diffuse", || vector(example().diffuse)),
    ("step05-specular", || vector(example().specular)),
    ("step05-sum", || vector(example().sum())),
    ("step05-pixel", || rgb(picture(&camera(), 1).get_pixel(PIXEL.0, PIXEL.1).0)),
    ("step05-half-1", || half_width(1.0)),
    ("step05-half-10", || half_width(10.0)),
    ("step05-half-16", || half_width(16.0)),
    ("step05-half-40", || half_width(40.0)),
    ("step05-half-300", || half_width(300.0)),
    ("step05-gate-pixels", || UNGATED.0.to_string()),
    ("step05-gate-most", || UNGATED.1.to_string()),
    ("step05-edge-cosine", || short(lit((605, 165), 1).cosine)),
    ("step05-edge-below", || short(lit((605, 166), 1).cosine)),
    ("step05-edge-alignment", || short(lit((605, 165), 1).alignment)),
    ("step05-edge-specular", || vector(lit((605, 165), 1).specular)),
    ("step05-teal-v-length", || short(teal().0)),
    ("step05-teal-specular", || {
        let ray = camera().ray(583.0, 215.0);
        terms(&scene(), &ray).map_or(String::new(), |terms| vector(terms.specular))
    }),
    ("step05-check-r-s", || {
        let r_s = |(k, object): (usize, &Object<Material>)| {
            (k + 1) as f64 * object.material.specular.x
        };
        short(scene().objects.iter().enumerate().map(r_s).sum())
    }),
    ("step05-check-n", || {
        let n =
            |(k, object): (i32, &Object<Material>)| k * object.material.shininess;
        (1..).zip(&scene().objects).map(n).sum::<i32>().to_string()
    }),
    ("step05-teal-power", || short(teal().0.powi(teal().1))),
];

/// The angle in degrees at which cosⁿ is 1/2.
fn half_width(n: f64) -> String {
    tenths(0.5_f64.powf(1.0 / n).acos().to_degrees())
}

/// The length of V through a pixel that sees the teal sphere, and its shininess.
fn teal() -> (f64, i32) {
    let shininess = lit((583, 215), 0).point.material.shininess;
    (camera().ray(583.0, 215.0).direction.length(), shininess)
}
