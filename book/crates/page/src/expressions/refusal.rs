//! What a reader is told where Rust would refuse a text.

use crate::expressions::functions::{function_names_with_prefix, signatures_of};
use crate::expressions::parser::is_word_char;
use course::{Kind, Place};

/// Signs that people write, each with what Rust has for it.
const SIGNS: [(&str, &str); 11] = [
    ("×", "*"),
    ("·", "* between numbers, and a.dot(b) between vectors"),
    ("÷", "/"),
    ("−", "-"),
    ("²", ".powi(2)"),
    ("³", ".powi(3)"),
    ("^", ".powi(2) or .powf(0.5) for powers"),
    ("√", ".sqrt()"),
    ("≤", "<="),
    ("≥", ">="),
    ("=", "== to compare"),
];

/// The words and signs of all that is more than one expression.
const STATEMENTS: [&str; 22] = [
    "let", "if", "else", "match", "for", "while", "loop", "fn", "return", "{", "}", ";", "|", "&",
    "#", "?", "'", "\"", "@", "$", "\\", "[",
];

const ONE_EXPRESSION: &str = "One expression fits here, without let, if, blocks or \
    functions of your own. In place of an if, multiply by f64::from(a < b): it is 1 where \
    that's true, else 0.";

/// Sentence about a word or a sign that no expression may have here; None for others.
pub fn explain_unexpected_token(word: &str) -> Option<String> {
    if STATEMENTS.contains(&word) {
        return Some(ONE_EXPRESSION.to_owned());
    }
    if word == "*" {
        return Some("A value is missing before this. Powers are .powi(2).".to_owned());
    }
    let sign = SIGNS.iter().find(|(sign, _)| *sign == word);
    let closing = (word == ")").then(|| "This ) closes nothing.".to_owned());
    sign.map(|(sign, rust)| format!("For {sign}, Rust has {rust}.")).or(closing)
}

/// Why the value of a whole text does not fit.
pub fn explain_wrong_kind_of_result(text: &str, actual_kind: Kind, wanted: Kind) -> String {
    let cure = match (actual_kind, wanted) {
        (Kind::Whole, Kind::Number) => return explain_whole_number(text),
        (_, Kind::Truth) => " Compare something, as in a < b.",
        (Kind::Vector, Kind::Number) => " a.dot(b) makes a number of two vectors.",
        (Kind::Literal | Kind::Number, Kind::Vector) => " DVec3::splat(…) makes a vector of it.",
        _ => "",
    };
    format!(
        "This is {}, and {} belongs here.{cure}",
        kind_name_with_article(actual_kind),
        kind_name_with_article(wanted)
    )
}

/// Why `name` can't be called with values of these kinds, which have these texts; and which
/// of them is wrong, if it is one of them.
pub fn explain_refused_call(
    name: &str,
    arguments: &[(Kind, &str)],
    place: &Place,
) -> (Option<usize>, String) {
    let mut ways: Vec<_> = signatures_of(name).map(|(kinds, ..)| kinds).collect();
    let bare_name = name.trim_end_matches("()").trim_end_matches("value");
    let (is_method, is_operator) = (name.starts_with('.'), !name.contains(is_word_char));
    let Some(count) = ways.first().map(Vec::len) else {
        return (None, explain_unknown_name(name, arguments, place));
    };
    ways.retain(|kinds| kinds.len() == arguments.len());
    if ways.is_empty() {
        let receivers = usize::from(is_method);
        let (wanted, actual) = (count - receivers, arguments.len() - receivers);
        let sentence = format!("{bare_name} takes {wanted} in its parentheses, not {actual}.");
        return (None, sentence);
    }
    let takes =
        |index: usize, kind: Kind| ways.iter().any(|kinds| kind.is_accepted_as(kinds[index]));
    // What happens most: a whole number where another belongs.
    for (index, (kind, text)) in arguments.iter().enumerate() {
        let is_mixed = is_operator || !takes(index, Kind::Whole);
        if *kind == Kind::Whole && is_mixed && takes(index, Kind::Number) {
            return (Some(index), explain_whole_number(text));
        }
    }
    match arguments {
        [(Kind::Literal, text), ..] if is_method && takes(0, Kind::Literal) => {
            let cure = match text.starts_with('(') {
                true => "write _f64 behind a number in it".to_owned(),
                false => format!("write {text}_f64"),
            };
            (Some(0), format!("Rust can't tell yet which kind of number this is: {cure}."))
        }
        [(kind, _), ..] if is_method && !takes(0, *kind) => {
            let (wanted, actual) =
                (kind_name_with_article(ways[0][0]), kind_name_with_article(*kind));
            let cure = if name == ".pow()" { " Take .powi." } else { "" };
            (None, format!("{bare_name} belongs to {wanted}, and this is {actual}.{cure}"))
        }
        [(left_kind, _), (right_kind, _)] if is_operator => {
            let cure = match [left_kind, right_kind].contains(&&Kind::Truth) {
                true => " f64::from(a < b) is a number, 1 or 0.",
                false => "",
            };
            let (left_kind, right_kind) =
                (kind_name_with_article(*left_kind), kind_name_with_article(*right_kind));
            (None, format!("{bare_name} can't stand between {left_kind} and {right_kind}.{cure}"))
        }
        _ => {
            let wrong = (0..arguments.len()).find(|index| !takes(*index, arguments[*index].0));
            let index = wrong.unwrap_or(arguments.len() - 1);
            let (wanted, actual) = (
                kind_name_with_article(ways[0][index]),
                kind_name_with_article(arguments[index].0),
            );
            let cure = if name == ".powi()" { " Write 2, or take .powf." } else { "" };
            (Some(index), format!("{bare_name} takes {wanted} here, not {actual}.{cure}"))
        }
    }
}

/// Says that there is no `name`, and what there is.
fn explain_unknown_name(name: &str, arguments: &[(Kind, &str)], place: &Place) -> String {
    let bare = name.trim_end_matches("()");
    let is_known = |name: &str| signatures_of(name).next().is_some();
    let kind = arguments.first().map_or(Kind::Vector, |(kind, _)| *kind);
    if bare == "." {
        return "A name is missing behind this point.".to_owned();
    }
    if name.starts_with('.') {
        if is_known(&format!("{bare}()")) {
            return format!("Write {bare}(): it's a method.");
        }
        if is_known(bare) {
            return format!("Write {bare} without the (): it's a part of the vector.");
        }
        let takes =
            |name: &&str| signatures_of(name).any(|(kinds, ..)| kind.is_accepted_as(kinds[0]));
        let mut known_names: Vec<_> = function_names_with_prefix(".").filter(takes).collect();
        known_names.sort_unstable();
        known_names.dedup();
        let known_names = known_names.join(" ").replace("()", "");
        return format!(
            "{bare} isn't known here. Of {}, there is: {known_names}.",
            kind_name_with_article(kind)
        );
    }
    let method = bare.rsplit("::").next().unwrap_or_default().to_lowercase();
    // Only whole numbers have `pow`.
    let method = if method == "pow" { "powi".to_owned() } else { method };
    if name.ends_with("()") && is_known(&format!(".{method}()")) {
        let first = arguments.first().map_or("a", |(_, text)| *text);
        let further_arguments = if arguments.len() < 2 { "" } else { "…" };
        return match first.chars().all(|c| is_word_char(c) || c == '.') {
            true => format!("In Rust, it's a method: {first}.{method}({further_arguments})."),
            false => format!("In Rust, it's a method: ({first}).{method}({further_arguments})."),
        };
    }
    let cure = match &*method {
        "pi" | "π" => "Rust's π is std::f64::consts::PI.".to_owned(),
        _ if bare.starts_with("DVec3") || ["vec3", "dvec3", "rgb"].contains(&&*method) => {
            "DVec3::new(1.0, 0.0, 0.5) is a vector.".to_owned()
        }
        _ => {
            let variables = place.variables.iter().map(|(name, _)| *name);
            format!("These are: {}.", variables.collect::<Vec<_>>().join(", "))
        }
    };
    format!("{bare} isn't known here. {cure}")
}

/// How a whole number becomes an `f64`.
fn explain_whole_number(text: &str) -> String {
    let cure = match text.trim_start_matches('-').parse::<u32>() {
        Ok(_) => format!("{text}.0"),
        Err(_) => format!("f64::from({text})"),
    };
    format!("Write {cure}: Rust doesn't mix whole numbers with others.")
}

fn kind_name_with_article(kind: Kind) -> &'static str {
    match kind {
        Kind::Number | Kind::Literal => "a number",
        Kind::Whole => "a whole number",
        Kind::Vector => "a vector",
        Kind::Truth => "true or false",
        Kind::Attenuation => "an attenuation",
    }
}
