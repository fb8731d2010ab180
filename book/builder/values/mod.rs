//! The numbers of the chapters, computed when the book is built.

mod lit;
mod next;
mod slips;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;
mod worked;

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A number of a worked example, by name.
type Value = (&'static str, fn() -> String);

/// All values by their names. Each is computed once, when a page first asks for it.
static KNOWN: LazyLock<BTreeMap<&str, LazyLock<String>>> = LazyLock::new(|| {
    let lists = [
        step01::VALUES,
        step02::VALUES,
        step03::VALUES,
        step04::VALUES,
        step05::VALUES,
        slips::VALUES,
        next::VALUES,
    ];
    let values = lists.into_iter().flatten();
    values.map(|&(name, value)| (name, LazyLock::new(value))).collect()
});

/// The name of every value.
#[cfg(test)]
pub fn names() -> impl Iterator<Item = &'static str> {
    KNOWN.keys().copied()
}

/// Replaces each `{{#value name}}` in `text`, written by `write`.
pub fn fill(text: &str, write: impl Fn(&str) -> String) -> Result<String, String> {
    let Some((before, rest)) = text.split_once("{{#") else {
        return Ok(text.to_string());
    };
    let first_line = rest.lines().next().unwrap_or_default();
    let (directive, after) =
        rest.split_once("}}").ok_or(format!("{{{{#{first_line} has no }}}}"))?;
    if directive.starts_with("number ") {
        // It moves, and is put in place where the formula is converted.
        return Ok(format!("{before}{{{{#{directive}}}}}{}", fill(after, write)?));
    }
    let Some(name) = directive.strip_prefix("value ").map(str::trim) else {
        return Err(match directive.split(' ').next().unwrap_or_default() {
            "include" => {
                "an include stands alone in a fence that names its language".into()
            }
            "figure" => "a figure stands alone in its paragraph".into(),
            "by-hand" => "the name of a test stands alone in its paragraph".into(),
            "predict" | "hints" | "aside" | "end" => {
                "a box begins and ends with a paragraph of its own".into()
            }
            word => format!("there is no directive {{{{#{word}}}}}"),
        });
    };
    let value = KNOWN.get(name).ok_or(format!("there is no value {name}"))?;
    Ok(format!("{before}{}{}", write(value), fill(after, write)?))
}
