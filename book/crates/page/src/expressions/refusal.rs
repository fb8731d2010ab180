//! What a reader is told where Rust would refuse a text.

use crate::expressions::functions::FUNCTIONS;
use crate::expressions::node::{Function, Part};
use crate::expressions::types::Type;
use course::Place;
use std::ops::Range;

/// Functions of a type that aren't methods.
pub const ASSOCIATED: [&str; 4] = ["new", "splat", "from", "from_array"];

/// Beginning of a list of the names that a line may use.
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
pub fn explain_mismatch(subject: &str, part: &Part, text: &str, wanted: &Type) -> String {
    let actual = &part.kind;
    if wanted.is_real() && actual.is_whole() {
        return explain_whole_number(&text[part.range.clone()], actual);
    }
    let cure = match (actual, wanted) {
        (Type::Reference(inner), _) if **inner == *wanted => " Leave out the &.",
        (_, Type::Bool) => " Compare something, as in a < b.",
        (Type::DVec3, Type::F64) => " a.dot(b) makes a number of two vectors.",
        (Type::F64 | Type::OpenF64, Type::DVec3) => " DVec3::splat(…) makes a vector of it.",
        (Type::F64 | Type::OpenF64, Type::I32) => " Write 2, or take .powf.",
        (_, Type::I32) if actual.is_whole() => " Write as i32 behind it.",
        (_, Type::Usize) if actual.is_whole() => " Write as usize behind it.",
        (_, Type::U32) if actual.is_whole() => " Write as u32 behind it.",
        _ => "",
    };
    format!("{subject} {}, not {}.{cure}", wanted.describe(), actual.describe())
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

/// Why what is written as `sign` can't be called with these values, and which of them is wrong, if
/// it is one; the rows are those of its name.
pub fn explain_refused_call(
    sign: &str,
    rows: &[&Function],
    parts: &[Part],
    text: &str,
) -> (Option<Range<usize>>, String) {
    let kinds: Vec<_> = parts.iter().map(|part| part.kind.clone()).collect();
    let whole_number = parts.iter().find(|part| part.kind.is_whole());
    if let (Some(row), true) = (rows.first(), sign.contains("::") || sign.starts_with('.')) {
        let receivers = usize::from(sign.starts_with('.'));
        if row.takes.len() != parts.len() {
            let (wanted, count) = (row.takes.len() - receivers, parts.len() - receivers);
            let values = if wanted == 1 { "one value".into() } else { format!("{wanted} values") };
            return (None, format!("{sign} takes {values} in its parentheses, not {count}."));
        }
        let mut pairs = parts.iter().zip(&row.takes);
        if let Some((part, wanted)) = pairs.find(|(part, wanted)| !part.kind.fits(wanted)) {
            let sentence = explain_mismatch(&format!("{sign} takes"), part, text, wanted);
            return (Some(part.range.clone()), sentence);
        }
    }
    let is_real = |kind: &Type| *kind == Type::DVec3 || kind.is_real();
    if let (Some(whole_number), true) = (whole_number, sign != "^" && kinds.iter().any(is_real)) {
        let sentence = explain_whole_number(&text[whole_number.range.clone()], &whole_number.kind);
        return (Some(whole_number.range.clone()), sentence);
    }
    let cure = match (sign, &kinds[..]) {
        ("^", _) => " For powers, Rust has .powi(2) or .powf(0.5).",
        _ if kinds.contains(&Type::Bool) => " f64::from(a < b) is a number, 1 or 0.",
        (_, [_, _]) if kinds.iter().all(Type::is_whole) => " Write as i32 behind one of them.",
        _ => "",
    };
    let kinds: Vec<_> = kinds.iter().map(|kind| kind.describe()).collect();
    (None, format!("{sign} can't be used with {}.{cure}", kinds.join(" and ")))
}

/// Why no method of a number such as 2.0 can be called.
pub fn explain_open_number(text: &str) -> String {
    let cure = match text.starts_with(|sign: char| sign.is_ascii_digit()) {
        true => format!("write {text}_f64"),
        false => "write _f64 behind a number in it".to_owned(),
    };
    format!("Rust can't tell yet which kind of number this is: {cure}.")
}

/// Says that there is no such name, and lists those that there are.
pub fn explain_unknown_name(name: &str, place: &Place) -> String {
    let last = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    let cure = match &*last {
        "pi" => "Rust's π is std::f64::consts::PI.".to_owned(),
        _ if name.starts_with("DVec3") || ["vec3", "dvec3", "rgb", "color"].contains(&&*last) => {
            "DVec3::new(1.0, 0.0, 0.5) is a vector.".to_owned()
        }
        _ => {
            let variables = place.variables.iter().map(|(name, _)| *name);
            format!("{NAMES_ARE}{}", variables.collect::<Vec<_>>().join(", "))
        }
    };
    format!("{name} isn't known here. {cure}")
}

/// Says that a type has no such `.FIELD` or `::METHOD`, and lists those that it has.
pub fn explain_unknown_member(member: &str, kind: &Type) -> String {
    let owner = kind.referent().name();
    let (name, is_method) = (member.trim_start_matches(['.', ':']), member.starts_with(':'));
    let has = |owner: &str, member: &str| {
        FUNCTIONS.iter().any(|one| one.name.strip_prefix(owner) == Some(member))
    };
    let kind = kind.describe();
    if !is_method && has(owner, &format!("::{name}")) {
        return format!("Write .{name}(): it's a method.");
    }
    if is_method && has(owner, &format!(".{name}")) {
        return format!("Write .{name} without the (): it's a field.");
    }
    if let Some(other) = [Type::F64, Type::DVec3].iter().find(|other| has(other.name(), member)) {
        return format!(".{name} belongs to {}, and this is {kind}.", other.describe());
    }
    if name == "pow" {
        return format!(".pow belongs to a whole number, and this is {kind}. Take .powi.");
    }
    let names =
        FUNCTIONS.iter().filter_map(|one| one.name.strip_prefix(owner)?.strip_prefix(['.', ':']));
    let names = names.map(|name| name.trim_start_matches(':'));
    let is_listed =
        |name: &&str| name.starts_with(char::is_lowercase) && !ASSOCIATED.contains(name);
    let mut names: Vec<_> = names.filter(is_listed).collect();
    names.sort_unstable();
    format!(".{name} isn't known here. Of {kind}, there is:\n{}", names.join(", "))
}

/// Names the method that Rust has for a function that is not known, if it has one.
pub fn explain_unknown_function(name: &str, first: &str, count: usize) -> Option<String> {
    let method = name.rsplit("::").next().unwrap_or_default().to_ascii_lowercase();
    // Only whole numbers have `pow`.
    let method = if method == "pow" { "powi".to_owned() } else { method };
    let names = ["f64", "DVec3"].map(|owner| format!("{owner}::{method}"));
    let is_method = FUNCTIONS.iter().any(|one| names.iter().any(|name| name == one.name));
    let others = if count < 2 { "" } else { "…" };
    is_method.then(|| format!("In Rust, it's a method: {first}.{method}({others})."))
}
