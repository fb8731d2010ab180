//! The numbers of a chapter that move when its reader moves what answers.

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Each number as it is printed, by the name of what it belongs to and its own, such
/// as `row:hRes`.
static PRINTED: LazyLock<BTreeMap<String, String>> = LazyLock::new(|| {
    let all = live::LIVE.into_iter().flat_map(|live| {
        let numbers = (live.numbers)(&live.values()).into_iter();
        numbers.map(|(name, text)| (format!("{}:{name}", live.name), text))
    });
    all.collect()
});

const BEGIN: &str = "{{#number ";

/// Replaces each `{{#number row:hRes}}` in a text by the element that holds it.
pub fn fill(text: &str) -> Result<String, String> {
    replace(text, BEGIN, "}}", |which| html("span", which))
}

/// Does the same for a formula: `convert` gets it with a mark in its place.
pub fn in_formula(
    latex: &str,
    convert: impl FnOnce(&str) -> Result<String, String>,
) -> Result<String, String> {
    let marked =
        replace(latex, BEGIN, "}}", |which| Ok(format!("\\text{{⟦{which}⟧}}")))?;
    let mathml = convert(&marked)?;
    replace(&mathml, "<mtext>⟦", "⟧</mtext>", |which| html("mn", which))
}

fn html(tag: &str, which: &str) -> Result<String, String> {
    let printed = printed(which)?;
    Ok(format!("<{tag} data-number=\"{which}\">{printed}</{tag}>"))
}

/// A number as it is printed.
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
    let mut replaced = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(begin)
        && let Some((inside, after)) = after.split_once(end)
    {
        replaced += before;
        replaced += &with(inside)?;
        rest = after;
    }
    Ok(replaced + rest)
}
