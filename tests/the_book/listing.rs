//! A listing is what its caption says: these lines of that file.

use anyhow::{Context, Result, bail, ensure};
use book::{Element, Page};

/// Code on a page that is Rust, or that says which file it is from.
#[derive(Clone, Debug)]
pub struct Listing<'a> {
    /// The page it stands on, and the line there.
    pub at: String,
    /// The file it is from, as seen from the root of the workspace; "" if none.
    pub path: &'a str,
    /// The first and the last of its lines, as the page has them: `3-14`.
    range: &'a str,
    caption: &'a str,
    pub code: &'a str,
    rust: bool,
}

impl<'a> Listing<'a> {
    /// Every listing of a page, from top to bottom.
    pub fn all(page: &'a Page) -> impl Iterator<Item = Listing<'a>> {
        page.all("code").filter_map(|code| Self::of(page, code))
    }

    /// The listing that an element `code` is.
    pub fn of(page: &'a Page, code: &'a Element) -> Option<Self> {
        let rust = ["rust", "rs"].iter().any(|name| {
            code.is("code", name) || code.is("code", &format!("language-{name}"))
        });
        let figure = page.around(code).find(|e| e.is("figure", "listing"));
        if !rust && figure.is_none() {
            return None;
        }
        let get = |name| figure.and_then(|f| f.get(name)).unwrap_or_default();
        let caption = page
            .all("figcaption")
            .find(|caption| figure.is_some_and(|f| page.within(caption, f)));
        Some(Self {
            at: page.at(code),
            path: get("data-path"),
            range: get("data-lines"),
            caption: caption.map_or("", |caption| &caption.text),
            // mdBook ends the last line of all code but Rust.
            code: code
                .text
                .strip_suffix('\n')
                .filter(|_| !rust)
                .unwrap_or(&code.text),
            rust,
        })
    }

    /// The numbers of its first and of its last line, from 1.
    pub fn lines(&self) -> Option<(usize, usize)> {
        let (first, last) = self.range.split_once('-')?;
        Some((first.parse().ok()?, last.parse().ok()?))
    }

    /// Says what is wrong with it, where `source` is the text of its file.
    pub fn check(&self, source: Option<&str>) -> Result<()> {
        let Self { at, path, range, caption, .. } = self;
        ensure!(!path.is_empty(), "The code on {at} says no file that it is from.");
        let is_of_step = path.starts_with("steps/");
        ensure!(
            !self.rust || is_of_step,
            "The Rust on {at} is from {path}, no step."
        );
        let source = source.with_context(|| {
            format!("The listing on {at} is from {path}, which is no file.")
        })?;
        let source: Vec<&str> = source.lines().collect();
        let total = source.len();
        let within =
            |&(first, last): &_| 0 < first && first <= last && last <= total;
        let (first, last) = self.lines().filter(within).with_context(|| {
            format!(
                "The listing on {at} is lines {range} of {path}, which has {total}."
            )
        })?;
        let right = right_caption(path, first, last, total);
        ensure!(
            *caption == right,
            "The caption on {at} is {caption:?}, not {right:?}."
        );
        let code: Vec<_> = self.code.split('\n').collect();
        let source = &source[first - 1..last];
        let differs = |&k: &usize| code.get(k) != source.get(k);
        if let Some(k) = (0..code.len().max(source.len())).find(differs) {
            let [shown, line] = [&code[..], source].map(|lines| lines.get(k));
            let number = first + k;
            bail!(
                "Line {number} of {path}, {line:?}, is {shown:?} in the listing on {at}."
            );
        }
        Ok(())
    }
}

/// The caption of these lines of a file that has `total`.
fn right_caption(path: &str, first: usize, last: usize, total: usize) -> String {
    let path = path.strip_prefix("steps/").unwrap_or(path);
    match (first, last) {
        (1, last) if last == total => path.to_string(),
        (first, last) if first == last => format!("{path} line {first} of {total}"),
        _ => format!("{path} lines {first}–{last} of {total}"),
    }
}
