//! The source of a crate, turned into that of a module.

/// Turns the text of a crate's file into a file of a module of another crate. The module's path is
/// `path`, such as `steps::step03_nearest`. Crates whose names begin with one of `siblings` are
/// modules beside it; all others are still crates.
///
/// It replaces `crate::`, and `use` before a sibling, which are the only ways in which the steps
/// name themselves and each other.
pub fn crate_as_module<'a>(
    text: &str,
    path: &str,
    siblings: impl IntoIterator<Item = &'a str>,
) -> String {
    let text = text.replace("crate::", &format!("crate::{path}::"));
    let parent = path.rsplit_once("::").map_or(String::new(), |(parent, _)| format!("::{parent}"));
    siblings.into_iter().fold(text, |text, sibling| {
        text.replace(&format!("use {sibling}"), &format!("use crate{parent}::{sibling}"))
    })
}
