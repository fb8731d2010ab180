use crate::page::Page;
use std::collections::BTreeMap;
use std::path::Path;

/// The id that mdBook gives to a heading of this text.
pub fn id_of(heading: &str) -> String {
    let letters = heading.trim().to_lowercase();
    let letters = letters.chars().map(|c| if c.is_whitespace() { '-' } else { c });
    letters.filter(|c| c.is_alphanumeric() || matches!(c, '_' | '-')).collect()
}

/// `id`, or where a heading before has it, `id` with a number at its end.
pub fn unique(id: &str, used: &[String]) -> String {
    let taken = |id: &String| used.contains(id);
    let numbered = (1..).map(|n| format!("{id}-{n}"));
    std::iter::once(id.to_string())
        .chain(numbered)
        .find(|id| !taken(id))
        .unwrap_or_default()
}

/// The values of an attribute in a piece of HTML.
pub fn attributes(html: &str, name: &str) -> Vec<String> {
    let mark = format!(" {name}=\"");
    let values =
        html.split(&mark).skip(1).filter_map(|rest| rest.split('"').next());
    values.map(str::to_string).collect()
}

/// What is wrong with a link from the chapter at `from`, if it stays inside the
/// book.
pub fn check(
    target: &str,
    from: &Path,
    pages: &BTreeMap<&Path, &Page>,
    chapters: &Path,
) -> Option<String> {
    if target.contains("://") || target.starts_with("mailto:") {
        return None;
    }
    let (path, id) = target.split_once('#').unwrap_or((target, ""));
    let Some(page) =
        pages.get(if path.is_empty() { from } else { Path::new(path) })
    else {
        let is_file = chapters.join(path).is_file() && !path.ends_with(".md");
        return (!is_file)
            .then(|| format!("the link goes to {path}, which is no chapter"));
    };
    let found = id.is_empty() || page.ids.iter().any(|known| known == id);
    (!found)
        .then(|| format!("the link goes to #{id}, which is not in that chapter"))
}
