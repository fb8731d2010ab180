//! What a reader is told where a function can't be called, or where another type is wanted.

use crate::expressions::expression::Part;
use crate::expressions::functions::{FUNCTIONS, find_function, is_known};
use crate::expressions::refusal::Refusal;
use crate::expressions::value::{SAMPLES, Value};
use course::Place;
use std::collections::BTreeSet;
use std::ops::Range;

/// Functions of a type that no value has as its method.
const NO_METHODS: [&str; 3] = ["from", "new", "splat"];

/// Why a value does not fit where another type is wanted; the subject begins the sentence.
pub fn explain_mismatch(subject: &str, part: &Part, text: &str, wanted: &Value) -> String {
    let (actual, text) = (&part.sample, &text[part.range.clone()]);
    let cure = match (actual, wanted) {
        (Value::I32(_), Value::F64(_) | Value::Vector(_)) => {
            let is_literal = text.parse::<i32>().is_ok();
            let cure = if is_literal { format!("{text}.0") } else { format!("f64::from({text})") };
            return format!("Write {cure}: Rust doesn't mix whole numbers with others.");
        }
        (_, Value::Bool(_)) => " Compare something, as in a < b.",
        (Value::Bool(_), Value::F64(_)) => " f64::from(a < b) is a number, 1 or 0.",
        (Value::Vector(_), Value::F64(_)) => " a.dot(b) makes a number of two vectors.",
        (Value::F64(_), Value::Vector(_)) => " DVec3::splat(…) makes a vector of it.",
        (Value::F64(_), Value::I32(_)) => " Write 2, or take .powf.",
        _ => "",
    };
    format!("{subject} {}, not {}.{cure}", wanted.describe().1, actual.describe().1)
}

/// Why a function, whose name is at `sign`, can't be called with these values, and what is wrong.
pub fn explain_refused_call(
    name: &str,
    sign: Range<usize>,
    parts: &[Part],
    place: &Place,
    text: &str,
) -> Refusal {
    let shown_name = &text[sign.clone()];
    let values: Vec<_> = parts.iter().map(|part| part.sample).collect();
    for (_, sample, _) in SAMPLES {
        for (index, part) in parts.iter().enumerate().rev() {
            let mut other_values = values.clone();
            other_values[index] = sample;
            if find_function(name, &other_values).is_some() {
                let subject = format!("{shown_name} takes");
                let sentence = explain_mismatch(&subject, part, text, &sample);
                return Refusal { range: part.range.clone(), sentence };
            }
        }
    }
    let sentence = match name {
        "^" => "For powers, Rust has .powi(2) or .powf(0.5).".to_owned(),
        _ if name.starts_with('[') => {
            "An array here has three numbers, [0], [1] and [2].".to_owned()
        }
        _ if name.starts_with("as ") => "Behind as, there is f64 or i32.".to_owned(),
        _ if is_known(name) => format!("{shown_name} takes other values, or more or fewer."),
        _ if shown_name.starts_with('.') => explain_unknown_member(shown_name, &values[0]),
        _ if name.contains(char::is_alphanumeric) => explain_unknown_name(name, parts, place, text),
        _ => format!("A page can't draw with {name}."),
    };
    Refusal { range: sign, sentence }
}

/// Says that there is no such name, and lists those that there are; it may be called with parts.
fn explain_unknown_name(name: &str, parts: &[Part], place: &Place, text: &str) -> String {
    let last = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    if let [first, others @ ..] = parts
        && is_known(&format!("{}::{last}", first.sample.describe().0))
    {
        let (first, dots) = (&text[first.range.clone()], if others.is_empty() { "" } else { "…" });
        return format!("In Rust, it's a method: {first}.{last}({dots}).");
    }
    let cure = match &*last {
        "pi" => "Rust's π is std::f64::consts::PI.",
        _ if last.contains("vec3") => "DVec3::new(1.0, 0.0, 0.5) is a vector.",
        _ => {
            let variables = place.variables.iter().map(|(name, _)| *name);
            &format!("These are:\n{}", variables.collect::<Vec<_>>().join(", "))
        }
    };
    // Such as the sphere of sphere.centre.
    let is_known_in_part = place
        .variables
        .iter()
        .any(|(known, _)| known.strip_prefix(name).is_some_and(|rest| rest.starts_with('.')));
    let alone = if is_known_in_part { " alone" } else { "" };
    format!("{name}{alone} isn't known here. {cure}")
}

/// Says that a value has no such field or method, and lists those that it has.
fn explain_unknown_member(shown_name: &str, receiver: &Value) -> String {
    let (kind, words) = receiver.describe();
    let members = FUNCTIONS.iter().copied().flatten().filter_map(|(name, _)| {
        let member = name.strip_prefix(kind)?;
        member.strip_prefix('.').map(str::to_owned).or_else(|| {
            let name = member.strip_prefix("::")?;
            let is_method = name.starts_with(char::is_lowercase) && !NO_METHODS.contains(&name);
            is_method.then(|| format!("{name}()"))
        })
    });
    let members: Vec<_> = members.collect::<BTreeSet<_>>().into_iter().collect();
    format!("{shown_name} isn't known here. Of {words}, there is:\n{}", members.join(", "))
}
