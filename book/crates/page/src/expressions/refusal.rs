//! What a reader is told where Rust would refuse a text.

use crate::expressions::functions::FUNCTIONS;
use crate::expressions::node::Part;
use crate::expressions::types::{Type, Types};
use course::Place;
use std::ops::Range;

/// Functions of a type that aren't methods.
pub const ASSOCIATED: [&str; 4] = ["new", "splat", "from", "from_array"];

/// What is before the names that a line may use.
pub const NAMES_ARE: &str = "These are:\n";

/// Fault in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Bytes of the text that are wrong.
    pub range: Range<usize>,
    /// One or two sentences for the reader; a list of names may follow, on a line of its own.
    pub sentence: String,
}

/// Refuses a part of a text.
pub fn refuse<T>(range: Range<usize>, sentence: impl Into<String>) -> Result<T, Refusal> {
    Err(Refusal { range, sentence: sentence.into() })
}

/// Why a value does not fit where another type is wanted; the subject begins the sentence.
pub fn explain_mismatch(
    types: &Types,
    subject: &str,
    part: &Part,
    text: &str,
    wanted: &Type,
) -> String {
    let (actual, wanted) = (types.resolve(&part.kind), types.resolve(wanted));
    let text = &text[part.range.clone()];
    let is_number =
        wanted == Type::F64 || matches!(wanted, Type::Open(_)) && !types.is_whole(&wanted);
    if is_number && types.is_whole(&actual) {
        return explain_whole_number(text, &actual);
    }
    let cure = match (&actual, &wanted) {
        (Type::Reference(inner), _) if **inner == wanted => " Leave out the &.".to_owned(),
        (_, Type::Reference(inner)) if **inner == actual => " Put a & before it.".to_owned(),
        (_, Type::Bool) => " Compare something, as in a < b.".to_owned(),
        (Type::DVec3, Type::F64) => " a.dot(b) makes a number of two vectors.".to_owned(),
        (Type::F64 | Type::Open(_), Type::DVec3) => {
            " DVec3::splat(…) makes a vector of it.".to_owned()
        }
        (Type::F64 | Type::Open(_), Type::I32) => " Write 2, or take .powf.".to_owned(),
        (_, kind) if kind.is_whole() && actual.is_plain() => {
            format!(" Write as {} behind it.", kind.name().unwrap_or_default())
        }
        _ => String::new(),
    };
    format!("{subject} {}, not {}.{cure}", types.describe(&wanted), types.describe(&actual))
}

/// How a whole number becomes an `f64`.
fn explain_whole_number(text: &str, kind: &Type) -> String {
    let cure = match text.trim_start_matches('-').bytes().all(|sign| sign.is_ascii_digit()) {
        true => format!("{text}.0"),
        false if *kind == Type::Usize => format!("({text}) as f64"),
        false => format!("f64::from({text})"),
    };
    format!("Write {cure}: Rust doesn't mix whole numbers with others.")
}

/// Why an operator has no meaning for these values, and which of them is wrong, if it is one.
pub fn explain_operands(
    types: &Types,
    sign: &str,
    parts: &[Part],
    text: &str,
) -> (Option<Range<usize>>, String) {
    let kinds: Vec<_> = parts.iter().map(|part| types.resolve(&part.kind)).collect();
    let whole = parts.iter().find(|part| types.is_whole(&part.kind));
    let is_real = |kind: &Type| *kind == Type::DVec3 || types.fits(kind, &Type::F64);
    if let (Some(whole), true) = (whole, kinds.iter().any(is_real)) {
        let sentence = explain_whole_number(&text[whole.range.clone()], &whole.kind);
        return (Some(whole.range.clone()), sentence);
    }
    let cure = match (sign, &kinds[..]) {
        ("^", _) => " For powers, Rust has .powi(2) or .powf(0.5).",
        _ if kinds.contains(&Type::Bool) => " f64::from(a < b) is a number, 1 or 0.",
        (_, [Type::Reference(_), _] | [_, Type::Reference(_)]) => " Leave out the &.",
        (_, [_, _]) if kinds.iter().all(Type::is_whole) => " Write as i32 behind one of them.",
        _ => "",
    };
    let kinds: Vec<_> = kinds.iter().map(|kind| types.describe(kind)).collect();
    (
        None,
        format!("{} can't be used with {}.{cure}", sign.replace("neg", "-"), kinds.join(" and ")),
    )
}

/// Why no method of a number such as 2.0 can be called.
pub fn explain_open_number(text: &str) -> String {
    let cure = match text.starts_with(|sign: char| sign.is_ascii_digit()) {
        true => format!("write {text}_f64"),
        false => "write _f64 behind a number in it".to_owned(),
    };
    format!("Rust can't tell yet which kind of number this is: {cure}.")
}

/// That there is no such name, and what there is.
pub fn explain_unknown_name(name: &str, place: &Place) -> String {
    let last = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    let cure = match &*last {
        "pi" => "Rust's π is std::f64::consts::PI.".to_owned(),
        _ if name.starts_with("DVec3") => "DVec3::new(1.0, 0.0, 0.5) is a vector.".to_owned(),
        _ => {
            let variables = place.variables.iter().map(|(name, _)| *name);
            format!("{NAMES_ARE}{}", variables.collect::<Vec<_>>().join(", "))
        }
    };
    format!("{name} isn't known here. {cure}")
}

/// That a type has no such `.FIELD` or `::METHOD`, and what it has.
pub fn explain_unknown_member(types: &Types, member: &str, kind: &Type) -> String {
    let owner = kind.referent().name().unwrap_or_default();
    let (name, is_method) = (member.trim_start_matches(['.', ':']), member.starts_with(':'));
    let has = |owner: &str, member: &str| {
        FUNCTIONS.iter().any(|one| one.name.strip_prefix(owner) == Some(member))
    };
    let kind = types.describe(kind);
    let other = ["f64", "DVec3"].into_iter().find(|other| has(other, member));
    match other.and_then(Type::from_name) {
        _ if !is_method && has(owner, &format!("::{name}")) => {
            return format!("Write .{name}(): it's a method.");
        }
        _ if is_method && has(owner, &format!(".{name}")) => {
            return format!("Write .{name} without the (): it's a field.");
        }
        Some(other) => {
            return format!(".{name} belongs to {}, and this is {kind}.", types.describe(&other));
        }
        None if has("i32", member) => {
            return format!(".{name} belongs to a whole number, and this is {kind}. Take .powi.");
        }
        None => {}
    }
    let names = FUNCTIONS.iter().filter_map(|one| one.name.strip_prefix(owner));
    let names = names.filter(|name| name.starts_with([':', '.']));
    let mut names: Vec<_> = names.map(|name| name.trim_start_matches([':', '.'])).collect();
    names.retain(|name| {
        name.starts_with(|sign: char| sign.is_ascii_lowercase()) && !ASSOCIATED.contains(name)
    });
    names.sort_unstable();
    format!(".{name} isn't known here. Of {kind}, there is:\n{}", names.join(", "))
}

/// What there is in place of a function that is not known, if something is.
pub fn explain_unknown_function(name: &str, first: &str, count: usize) -> Option<String> {
    let method = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    // Only whole numbers have `pow`.
    let method = if method == "pow" { "powi".to_owned() } else { method };
    if ["vec3", "dvec3", "rgb", "color"].contains(&&*method) {
        return Some(format!("{name} isn't known here. DVec3::new(1.0, 0.0, 0.5) is a vector."));
    }
    let names = ["f64", "DVec3"].map(|owner| format!("{owner}::{method}"));
    let is_method = FUNCTIONS.iter().any(|one| names.iter().any(|name| name == one.name));
    let others = if count < 2 { "" } else { "…" };
    is_method.then(|| format!("In Rust, it's a method: {first}.{method}({others})."))
}
