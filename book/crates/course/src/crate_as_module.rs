/// The text of a crate's file as a file of the module at `path`, such as `steps::step03_nearest`,
/// of another crate, whose root is `lib.rs` or `main.rs`. The crates that are named in `siblings`
/// are modules beside it; all others stay crates.
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
