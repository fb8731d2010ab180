//! What a reader is told where Rust would refuse a text.

use crate::expressions::compiler::Part;
use crate::expressions::functions::{FUNCTIONS, functions, is_known};
use crate::expressions::value::{SAMPLES, Value};
use course::Place;
use std::collections::BTreeSet;
use std::ops::Range;

/// Fault in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Bytes of the text that are wrong.
    pub range: Range<usize>,
    /// One or two sentences for the reader; a list of names may follow, on a line of its own.
    pub sentence: String,
}

pub type Checked<T> = Result<T, Refusal>;

/// Refuses a part of a text.
pub fn refuse<T>(range: Range<usize>, sentence: impl Into<String>) -> Checked<T> {
    Err(Refusal { range, sentence: sentence.into() })
}

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
    format!("{subject} {}, not {}.{cure}", wanted.describe(), actual.describe())
}

/// The lists of values, one of each type, that a function of this name takes.
fn find_signatures(name: &str) -> Vec<Vec<Value>> {
    let (mut lists, mut found) = (vec![vec![]], vec![]);
    for _ in 0..3 {
        let with_another = |list: &Vec<Value>| {
            SAMPLES.map(|(_, sample, _)| list.iter().copied().chain([sample]).collect())
        };
        lists = lists.iter().flat_map(with_another).collect();
        let fits = |list: &&Vec<Value>| {
            functions(name).any(|row| !matches!((row.apply)(list), Value::Unfit))
        };
        found.extend(lists.iter().filter(fits).cloned());
    }
    found
}

/// Why a function, whose name is at `sign`, can't be called with these values, and what is wrong.
pub fn explain_refused_call(
    name: &str,
    sign: Range<usize>,
    parts: &[Part],
    text: &str,
) -> (Range<usize>, String) {
    let shown_name = &text[sign.clone()];
    let fits = |(part, wanted): (&Part, &Value)| part.sample.is_like(wanted);
    // The one that is nearest to what is written.
    let signatures = find_signatures(name);
    let nearest = signatures.iter().rev().max_by_key(|list| {
        let count = parts.iter().zip(*list).filter(|pair| fits(*pair)).count();
        (list.len() == parts.len(), count)
    });
    let Some(wanted) = nearest else {
        let cure = match name {
            "^" => " For powers, Rust has .powi(2) or .powf(0.5).",
            _ if name.starts_with("as ") => " It knows as f64 and as i32.",
            _ => "",
        };
        return (sign, format!("A page can't draw with {name}.{cure}"));
    };
    let wanted_count = wanted.len();
    let receivers = usize::from(shown_name.starts_with('.'));
    let mut pairs = parts.iter().zip(wanted).enumerate();
    match pairs.find(|(_, pair)| !fits(*pair)) {
        Some((index, (part, wanted))) if wanted_count == parts.len() => {
            let verb = if index < receivers { "belongs to" } else { "takes" };
            let sentence = explain_mismatch(&format!("{shown_name} {verb}"), part, text, wanted);
            (part.range.clone(), sentence)
        }
        _ => {
            let [wanted, count] = [wanted_count, parts.len()].map(|count| count - receivers);
            let sentence = "The number of values is wrong";
            (sign, format!("{sentence}: {shown_name} takes {wanted}, not {count}."))
        }
    }
}

/// Says that there is no such name, and lists those that there are; it may be called with parts.
pub fn explain_unknown_name(name: &str, parts: &[Part], place: &Place, text: &str) -> String {
    let last = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    // Only whole numbers have `pow`.
    let method = if last == "pow" { "powi" } else { &last };
    if let Some(first) = parts.first().filter(|_| is_known(method)) {
        let (first, others) = (&text[first.range.clone()], if parts.len() < 2 { "" } else { "…" });
        return format!("In Rust, it's a method: {first}.{method}({others}).");
    }
    let cure = match &*last {
        "pi" => "Rust's π is std::f64::consts::PI.".to_owned(),
        _ if name.starts_with("DVec3") || ["vec3", "dvec3", "rgb", "color"].contains(&&*last) => {
            "DVec3::new(1.0, 0.0, 0.5) is a vector.".to_owned()
        }
        _ => {
            let variables = place.variables.iter().map(|(name, _)| *name);
            format!("These are:\n{}", variables.collect::<Vec<_>>().join(", "))
        }
    };
    format!("{name} isn't known here. {cure}")
}

/// Says that a value has no such `.FIELD` or `METHOD`, and lists those that it has.
pub fn explain_unknown_member(member: &str, receiver: &Value) -> String {
    let name = member.trim_start_matches('.');
    if is_known(name) {
        return format!("Write .{name}(): it's a method.");
    }
    if is_known(&format!(".{name}")) {
        return format!("Write .{name} without the (): it's a field.");
    }
    let takes_it = |name: &&str| {
        let is_part = |sign: char| sign.is_alphanumeric() || sign == '_';
        let mut signatures = find_signatures(name).into_iter();
        name.trim_start_matches('.').chars().all(is_part)
            && signatures.any(|list| list[0].is_like(receiver))
    };
    let names = FUNCTIONS.iter().copied().flatten().map(|row| row.name).filter(takes_it);
    let names: BTreeSet<_> = names.map(|name| name.trim_start_matches('.')).collect();
    let names = names.into_iter().collect::<Vec<_>>().join(", ");
    let cure = if name == "pow" { " Powers are .powi(2)." } else { "" };
    format!(".{name} isn't known here.{cure} Of {}, there is:\n{names}", receiver.describe())
}
