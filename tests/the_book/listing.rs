use book::{Page, all, text};
use scraper::ElementRef;

/// A listing: these lines of that file.
#[derive(Clone, Debug)]
pub struct Listing<'a> {
    /// Where on which page it stands.
    pub at: String,
    /// The file it is from, as seen from the root of the workspace.
    pub path: &'a str,
    /// The numbers of its first and of its last line, from 1.
    pub lines: (usize, usize),
    pub code: String,
}

impl<'a> Listing<'a> {
    /// Every listing of a page, from top to bottom.
    pub fn all(page: &'a Page) -> impl Iterator<Item = Self> {
        page.all(".listing").into_iter().map(|figure| Self::of(page, figure))
    }

    /// The listing that a figure holds.
    pub fn of(page: &'a Page, figure: ElementRef<'a>) -> Self {
        let at = page.at(figure);
        let code = all(figure, "code");
        let [code] = code[..] else { panic!("{at} has not one code") };
        let lines = figure.attr("data-lines").and_then(|lines| {
            let (first, last) = lines.split_once('-')?;
            Some((first.parse().ok()?, last.parse().ok()?))
        });
        let is_rust = code.attr("class").is_some_and(|name| name.contains("rust"));
        let mut code = text(code);
        // mdBook ends the last line of all code but Rust.
        if !is_rust && code.ends_with('\n') {
            code.pop();
        }
        Self {
            path: figure.attr("data-path").unwrap_or_default(),
            lines: lines.unwrap_or_else(|| panic!("{at} says no lines")),
            at,
            code,
        }
    }
}

/// The text of a file, of which these parts are shown.
pub fn joined(parts: &[Listing]) -> String {
    let mut parts: Vec<_> = parts.iter().collect();
    parts.sort_by_key(|part| part.lines);
    parts.iter().map(|part| format!("{}\n", part.code)).collect()
}
