//! The source of a crate as the source of a module.

/// Rewrites the text of a crate's file for use in the module at `path`, such as
/// `steps::step03_nearest`, of a different crate. The crates named in `siblings` become modules
/// beside it; all the rest remain crates.
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
