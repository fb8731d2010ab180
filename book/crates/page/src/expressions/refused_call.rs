//! Explains why a function can't be called, or why a value has the wrong type.

use crate::expressions::functions::{find_function, functions, is_known};
use crate::expressions::part::Part;
use crate::expressions::refusal::{Fault, Refusal};
use course::{Place, ValueType};
use std::collections::BTreeSet;
use std::ops::Range;

/// Associated functions that aren't methods.
const NO_METHODS: [&str; 3] = ["from", "new", "splat"];

/// Explains why a value doesn't fit where another type is wanted. `subject` begins the sentence.
pub fn explain_mismatch(subject: &str, part: &Part, text: &str, wanted: ValueType) -> Fault {
    use ValueType::{Bool, F64, I32, Vector};
    let (actual, text) = (part.value_type, &text[part.range.clone()]);
    let cure = match (actual, wanted) {
        (I32, F64 | Vector) => {
            let is_literal = text.parse::<i32>().is_ok();
            let cure = if is_literal { format!("{text}.0") } else { format!("f64::from({text})") };
            return Fault::WholeNumber { cure };
        }
        (_, Bool) => " Compare something, as in a < b.",
        (Bool, F64) => " f64::from(a < b) is a number, 1 or 0.",
        (Vector, F64) => " a.dot(b) makes a number of two vectors.",
        (F64, Vector) => " DVec3::splat(…) makes a vector of it.",
        (F64, I32) => " Write 2, or take .powf.",
        _ => "",
    };
    Fault::Mismatch { subject: subject.to_owned(), wanted, actual, cure }
}

/// Explains why the function named at range `sign` can't be called with these arguments, and which
/// range of the line to mark.
pub fn explain_refused_call(
    name: &str,
    sign: Range<usize>,
    parts: &[Part],
    place: &Place,
    text: &str,
) -> Refusal {
    let shown_name = &text[sign.clone()];
    let types: Vec<_> = parts.iter().map(|part| part.value_type).collect();
    for value_type in ValueType::ALL {
        for (index, part) in parts.iter().enumerate().rev() {
            let mut other_types = types.clone();
            other_types[index] = value_type;
            if find_function(name, &other_types).is_some() {
                let subject = format!("{shown_name} takes");
                let fault = explain_mismatch(&subject, part, text, value_type);
                return Refusal { range: part.range.clone(), fault };
            }
        }
    }
    let fault = match name {
        "^" => Fault::Caret,
        _ if name.starts_with('[') => Fault::Index,
        _ if name.starts_with("as ") => Fault::Cast,
        _ if is_known(name) => Fault::OtherValues(shown_name.to_owned()),
        _ if shown_name.starts_with('.') => explain_unknown_member(shown_name, types[0]),
        _ if name.contains(char::is_alphanumeric) => explain_unknown_name(name, parts, place, text),
        _ => Fault::Operator(name.to_owned()),
    };
    Refusal { range: sign, fault }
}

/// Explains that a name is unknown, and lists the known ones. If the name is called, `parts` are
/// its arguments.
fn explain_unknown_name(name: &str, parts: &[Part], place: &Place, text: &str) -> Fault {
    let last = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    if let [first, others @ ..] = parts
        && is_known(&format!("{}::{last}", first.value_type.name()))
    {
        let (first, dots) = (&text[first.range.clone()], if others.is_empty() { "" } else { "…" });
        return Fault::Method(format!("{first}.{last}({dots})"));
    }
    let cure = match &*last {
        "pi" => "Rust's π is std::f64::consts::PI.",
        _ if last.contains("vec3") => "DVec3::new(1.0, 0.0, 0.5) is a vector.",
        _ => {
            let variables = place.variables.iter().map(|(name, _)| *name);
            &format!("These are:\n{}", variables.collect::<Vec<_>>().join(", "))
        }
    };
    // For example, the `sphere` in `sphere.centre`.
    let is_known_in_part = place
        .variables
        .iter()
        .any(|(known, _)| known.strip_prefix(name).is_some_and(|rest| rest.starts_with('.')));
    let alone = if is_known_in_part { " alone" } else { "" };
    Fault::UnknownName { name: format!("{name}{alone}"), cure: cure.to_owned() }
}

/// Explains that a value has no such field or method, and lists those that it has.
fn explain_unknown_member(shown_name: &str, receiver: ValueType) -> Fault {
    let members = functions().filter_map(|function| {
        let member = function.name.strip_prefix(receiver.name())?;
        member.strip_prefix('.').map(str::to_owned).or_else(|| {
            let name = member.strip_prefix("::")?;
            let is_method = name.starts_with(char::is_lowercase) && !NO_METHODS.contains(&name);
            is_method.then(|| format!("{name}()"))
        })
    });
    let members: Vec<_> = members.collect::<BTreeSet<_>>().into_iter().collect();
    Fault::UnknownMember { name: shown_name.to_owned(), receiver, members: members.join(", ") }
}
