//! The numbers of chapters 4 and 5.

use super::{Value, short, vector};
use crate::shading::{
    Shaded, at, example, half_width, pixel_of_step_4, pixel_of_step_5,
};
use crate::worked::{UNGATED, count};
use glam::DVec3;
use step05_phong::{LIGHTS, Ray, SPHERES, nearest};

pub(super) const VALUES: &[Value] = &[
    ("step04-ray-direction", || vector(example().ray.direction)),
    ("step04-t", || short(example().hit.t)),
    ("step04-p", || vector(example().p)),
    ("step04-p-column", || column(example().p)),
    ("step04-centre", || vector(example().sphere.centre)),
    ("step04-centre-column", || column(example().sphere.centre)),
    ("step04-radius", || short(example().sphere.radius)),
    ("step04-n-column", || column(example().n)),
    ("step04-surface", || vector(example().material.surface.diffuse)),
    ("step04-ambient", || vector(example().terms.ambient)),
    ("step04-warm-l", || vector(example().lights[0].l)),
    ("step04-warm-d", || short(example().lights[0].d)),
    ("step04-warm-divisor", || short(example().lights[0].divisor)),
    ("step04-warm-cosine", || short(example().lights[0].n_dot_l)),
    ("step04-warm-diffuse", || vector(example().lights[0].diffuse)),
    ("step04-cool-l", || vector(example().lights[1].l)),
    ("step04-cool-d", || short(example().lights[1].d)),
    ("step04-cool-divisor", || short(example().lights[1].divisor)),
    ("step04-cool-cosine", || short(example().lights[1].n_dot_l)),
    ("step04-cool-diffuse", || vector(example().lights[1].diffuse)),
    ("step04-sum", || vector(example().terms.ambient + example().terms.diffuse)),
    ("step04-pixel", || rgb(pixel_of_step_4())),
    ("step04-behind-cosine", || short(at(380, 136).lights[1].n_dot_l)),
    ("step04-warm-at-0", || short(1.0 / LIGHTS[0].point.attenuation.at(0.0))),
    ("step04-warm-at-10", || short(1.0 / LIGHTS[0].point.attenuation.at(10.0))),
    ("step04-cool-at-0", || short(1.0 / LIGHTS[1].point.attenuation.at(0.0))),
    ("step04-cool-at-10", || short(1.0 / LIGHTS[1].point.attenuation.at(10.0))),
    ("step04-clipped", || {
        let lit = |ray: &Ray| step04_diffuse::colour(ray).max_element();
        let clipped =
            |ray: &Ray| nearest(&SPHERES, ray).is_some() && 1.0 < lit(ray);
        count(|ray| clipped(ray).into()).to_string()
    }),
    ("step05-v", || vector(example().v)),
    ("step05-v-length", || short(example().ray.direction.length())),
    ("step05-warm-r", || vector(example().lights[0].r)),
    ("step05-warm-alignment", || short(example().lights[0].r_dot_v)),
    ("step05-warm-specular", || vector(example().lights[0].specular)),
    ("step05-cool-r", || vector(example().lights[1].r)),
    ("step05-cool-alignment", || short(example().lights[1].r_dot_v)),
    ("step05-cool-angle", || {
        short(example().lights[1].r_dot_v.acos().to_degrees())
    }),
    ("step05-cool-power", || {
        let Shaded { material, lights: [_, cool], .. } = example();
        short(cool.r_dot_v.powi(material.shininess))
    }),
    ("step05-cool-specular", || vector(example().lights[1].specular)),
    ("step05-shininess", || example().material.shininess.to_string()),
    ("step05-r-s", || short(example().material.specular.x)),
    ("step05-diffuse", || vector(example().terms.diffuse)),
    ("step05-specular", || vector(example().terms.specular)),
    ("step05-sum", || vector(example().terms.sum())),
    ("step05-pixel", || rgb(pixel_of_step_5())),
    ("step05-half-1", || format!("{:.1}", half_width(1.0))),
    ("step05-half-10", || format!("{:.1}", half_width(10.0))),
    ("step05-half-16", || format!("{:.1}", half_width(16.0))),
    ("step05-half-40", || format!("{:.1}", half_width(40.0))),
    ("step05-half-150", || format!("{:.1}", half_width(150.0))),
    ("step05-half-300", || format!("{:.1}", half_width(300.0))),
    ("step05-gate-pixels", || UNGATED.0.to_string()),
    ("step05-gate-most", || UNGATED.1.to_string()),
    ("step05-edge-cosine", || short(at(605, 165).lights[1].n_dot_l)),
    ("step05-edge-below", || short(at(605, 166).lights[1].n_dot_l)),
    ("step05-edge-alignment", || short(at(605, 165).lights[1].r_dot_v)),
    ("step05-edge-specular", || vector(at(605, 165).lights[1].specular)),
    ("step05-teal-v-length", || short(at(583, 215).ray.direction.length())),
    ("step05-teal-power", || {
        let Shaded { material, ray, .. } = at(583, 215);
        short(ray.direction.length().powi(material.shininess))
    }),
];

/// A vector as a column, for a formula.
fn column(vector: DVec3) -> String {
    let rows = vector.to_array().map(short).join(r" \\ ");
    format!(r"\begin{{bmatrix}} {rows} \end{{bmatrix}}")
}

/// An 8-bit colour as (red, green, blue).
fn rgb(channels: [u8; 3]) -> String {
    format!("({})", channels.map(|channel| channel.to_string()).join(", "))
}
