mod appendices;
mod step01;
mod step02_step03;
mod step04_step05;

use crate::worked::camera;
use glam::DVec3;
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_3;
use std::sync::LazyLock;
use step02_sphere::{SPHERE, quadratic};

/// A number of a worked example, by name, computed when the book is built.
type Value = (&'static str, fn() -> String);

const VALUES: &[Value] = &[
    ("camera-tan", || short((FRAC_PI_3 / 2.0).tan())),
    ("camera-step", || short(camera().matrix.x_axis.x)),
    ("camera-v0-x", || short(camera().matrix.z_axis.x)),
    ("camera-v0-y", || short(camera().matrix.z_axis.y)),
    ("sphere-a", || short(coefficients().x)),
    ("sphere-b", || short(coefficients().y)),
    ("sphere-c", || short(coefficients().z)),
    ("sphere-discriminant", || {
        let DVec3 { x: a, y: b, z: c } = coefficients();
        short(b * b - 4.0 * a * c)
    }),
    ("sphere-near", || {
        let DVec3 { x: a, y: b, z: c } = coefficients();
        quadratic(a, b, c).first_hit().map_or("none".to_string(), short)
    }),
];

/// a, b and c for the ray through the pixel in column 300, row 150.
fn coefficients() -> DVec3 {
    SPHERE.coefficients(&camera().ray(300.0, 150.0)).into()
}

/// A number with four digits after the point, zeros at the end left out.
fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// A vector as (x, y, z).
fn vector(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(short).join(", "))
}

/// A whole number with a comma between thousands.
fn grouped(number: f64) -> String {
    let digits = format!("{number:.0}");
    let comma = |at: usize| 0 < at && (digits.len() - at).is_multiple_of(3);
    digits
        .char_indices()
        .map(|(at, c)| if comma(at) { format!(",{c}") } else { c.to_string() })
        .collect()
}

/// All values by their names. Each is computed once, when a page first asks for it.
static KNOWN: LazyLock<HashMap<&str, LazyLock<String>>> = LazyLock::new(|| {
    let lists = [
        VALUES,
        step01::VALUES,
        appendices::VALUES,
        step02_step03::VALUES,
        step04_step05::VALUES,
    ];
    let values = lists.into_iter().flatten();
    values.map(|&(name, value)| (name, LazyLock::new(value))).collect()
});

/// Replaces each `{{#value name}}` in `text`, written by `write`.
pub fn fill(text: &str, write: impl Fn(&str) -> String) -> Result<String, String> {
    let Some((before, rest)) = text.split_once("{{#") else {
        return Ok(text.to_string());
    };
    let (directive, after) = rest
        .split_once("}}")
        .ok_or_else(|| format!("{{{{#{} has no }}}}", first_line(rest)))?;
    let Some(name) = directive.strip_prefix("value ").map(str::trim) else {
        return Err(match directive.split(' ').next().unwrap_or_default() {
            "include" => {
                "an include stands alone in a fence that names its language"
                    .to_string()
            }
            "figure" => "a figure stands alone in its paragraph".to_string(),
            "predict" | "hints" | "aside" | "end" => {
                "a box begins and ends with a paragraph of its own".to_string()
            }
            _ => {
                format!("there is no directive {{{{#{}}}}}", first_line(directive))
            }
        });
    };
    let value =
        KNOWN.get(name).ok_or_else(|| format!("there is no value {name}"))?;
    Ok(format!("{before}{}{}", write(value), fill(after, write)?))
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}
