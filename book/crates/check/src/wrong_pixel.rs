//! Describes the one wrong pixel that an answer shows in full.

use crate::comparison::{Comparison, Pixel};
use crate::number_format::{format_four_decimals, format_vector_four_decimals};
use crate::step_scene::{ObjectHit, StepScene};
use course::Step;
use step05_phong::{Ray, normal};

/// Describes the wrong pixel that differs most: its colours in both pictures, and what our program
/// computes for it.
pub(crate) fn describe_most_different_pixel(
    Comparison { target, most_different, .. }: &Comparison,
) -> String {
    let Pixel { position: (i, j), ray, hit, yours, ours } = most_different;
    let computed = target.scene.as_ref().map(|scene| format_computed_values(scene, ray, *hit));
    let [a, b] = [yours, ours].map(|[r, g, b]| format!("({r}, {g}, {b})"));
    format!("Column {i}, row {j}: yours is {a}, ours {b}{}.", computed.unwrap_or_default())
}

/// Formats the values that our program computes for one ray, in the book's notation. The text
/// begins with a colon, because the text follows the two colours.
fn format_computed_values(scene: &StepScene, ray: &Ray, hit: Option<ObjectHit>) -> String {
    let Some(hit) = hit else {
        return format!(": the sky, V = {}", format_vector_four_decimals(ray.direction));
    };
    let mut text = format!(": {} at t = {:.4}", scene.object_names()[hit.object], hit.t);
    if scene.step < Step::Diffuse {
        return text;
    }
    let p = ray.at(hit.t);
    let n = normal(&scene.own_scene.scene.objects[hit.object].sphere, p);
    text += &format!(", n = {}", format_vector_four_decimals(n));
    for (light, name) in scene.own_scene.scene.lights.iter().zip(scene.light_names) {
        let (l, d) = light.point_light.direction_from(p);
        text += &format!("; {name}: n·l = {}, d = {d:.4}", format_four_decimals(n.dot(l)));
    }
    let terms = scene.terms_at_hit(ray, hit);
    text += &format!(
        ";\n  I_a = {}, I_d = {}",
        format_vector_four_decimals(terms.ambient),
        format_vector_four_decimals(terms.diffuse)
    );
    if scene.step == Step::Phong {
        text += &format!(", I_s = {}", format_vector_four_decimals(terms.specular));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_contains_the_values_that_the_step_computes() {
        let ray = course::camera().ray(320.0, 180.0);
        let values = |step| {
            let scene = StepScene::of_step(step);
            format_computed_values(&scene, &ray, scene.visible_hit(&ray))
        };
        assert!(values(Step::Rays).starts_with(": the sky, V = (0.0009, −0.0009, −1.0000)"));
        assert_eq!(values(Step::Sphere), ": the sphere at t = 4.0000");
        assert!(values(Step::Diffuse).contains("; the warm light: n·l = "));
        assert!(!values(Step::Diffuse).contains("I_s"));
        assert!(values(Step::Phong).contains(", I_s = ("));
    }
}
