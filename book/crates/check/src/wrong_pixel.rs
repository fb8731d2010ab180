use crate::comparison::{Comparison, Pixel};
use crate::drawing::{Drawing, ObjectHit};
use course::Step;
use glam::DVec3;
use step05_phong::{Ray, normal};

/// The wrong pixel that differs most: its colours, and what ours computes there.
pub(crate) fn describe_wrong_pixel(Comparison { target, farthest, .. }: &Comparison) -> String {
    let Pixel { place: (i, j), ray, hit, yours, ours } = farthest;
    let computed = target.drawing.as_ref().map(|drawing| computed_values(drawing, ray, *hit));
    let [a, b] = [yours, ours].map(|[r, g, b]| format!("({r}, {g}, {b})"));
    format!("Column {i}, row {j}: yours is {a}, ours {b}{}.\n", computed.unwrap_or_default())
}

/// The values that our program computes for one ray, in the book's letters, after a colon.
pub(crate) fn computed_values(drawing: &Drawing, ray: &Ray, hit: Option<ObjectHit>) -> String {
    let Some(hit) = hit else {
        return format!(": the sky, V = {}", format_vector(ray.direction));
    };
    let mut text = format!(": {} at t = {:.4}", drawing.object_names()[hit.object], hit.t);
    if drawing.step < Step::Diffuse {
        return text;
    }
    let p = ray.at(hit.t);
    let n = normal(&drawing.own.scene.objects[hit.object].sphere, p);
    text += &format!(", n = {}", format_vector(n));
    for (light, name) in drawing.own.scene.lights.iter().zip(drawing.light_names) {
        let (l, d) = light.point_light.direction_from(p);
        text += &format!("; {name}: n·l = {}, d = {d:.4}", format_number(n.dot(l)));
    }
    let terms = drawing.terms_at_hit(ray, hit);
    text += &format!(
        ";\n  I_a = {}, I_d = {}",
        format_vector(terms.ambient),
        format_vector(terms.diffuse)
    );
    if drawing.step == Step::Phong {
        text += &format!(", I_s = {}", format_vector(terms.specular));
    }
    text
}

pub(crate) fn format_vector(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(format_number).join(", "))
}

pub(crate) fn format_number(number: f64) -> String {
    format!("{number:.4}").replace('-', "−")
}
