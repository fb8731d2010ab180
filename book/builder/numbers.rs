//! The numbers in a text: values, computed when the book is built, and those that move
//! when a reader moves what answers.

use crate::values;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Each number that moves as it is printed, by the name of what it belongs to and its
/// own, such as `row:hRes`.
static PRINTED: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    let all = live::LIVE.iter().flat_map(|live| {
        let numbers = (live.numbers)(&live.default_values()).into_iter();
        numbers.map(|(name, text)| (format!("{}:{name}", live.name), text))
    });
    all.collect()
});

/// A text with the numbers of `{{#value name}}` and `{{#number row:hRes}}` in it, and
/// `minus` in the values: − in a text, a hyphen in code.
pub fn in_text(text: &str, minus: &str) -> Result<String, String> {
    replace(text, "{{#", "}}", |directive| match directive.split_once(' ') {
        Some(("value", name)) => Ok(values::get(name)?.replace('−', minus)),
        Some(("number", which)) => html("span", which),
        _ => Err(format!(
            "{{{{#{directive}}}}} stands alone, in a paragraph or a fence of its own, \
             or is none of the directives"
        )),
    })
}

/// The same for a formula: `convert` gets it with a mark where a number moves.
pub fn in_formula(
    latex: &str,
    convert: impl FnOnce(&str) -> Result<String, String>,
) -> Result<String, String> {
    let marked =
        replace(latex, "{{#", "}}", |directive| match directive.split_once(' ') {
            Some(("value", name)) => Ok(values::get(name)?.replace('−', "-")),
            Some(("number", which)) => Ok(format!("\\text{{⟦{which}⟧}}")),
            _ => Err(format!("a formula has no {{{{#{directive}}}}}")),
        })?;
    replace(&convert(&marked)?, "<mtext>⟦", "⟧</mtext>", |which| {
        html("mn", which)
    })
}

fn html(tag: &str, which: &str) -> Result<String, String> {
    let printed = printed(which)?;
    Ok(format!("<{tag} data-number=\"{which}\">{printed}</{tag}>"))
}

/// A number that moves as it is printed.
pub fn printed(which: &str) -> Result<&'static str, String> {
    let printed = PRINTED.get(which).map(String::as_str);
    printed.ok_or(format!("there is no number {which}"))
}

/// Replaces each part between `begin` and `end`.
fn replace(
    text: &str,
    begin: &str,
    end: &str,
    with: impl Fn(&str) -> Result<String, String>,
) -> Result<String, String> {
    let mut parts = text.split(begin);
    let mut replaced = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (inside, after) =
            part.split_once(end).ok_or(format!("{begin}{part} has no {end}"))?;
        replaced += &with(inside)?;
        replaced += after;
    }
    Ok(replaced)
}
