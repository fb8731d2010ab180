//! A listing is what its caption says: these lines of that file.

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

    fn of(page: &'a Page, code: &'a Element) -> Option<Self> {
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
    pub fn check(&self, source: Option<&str>) -> Result<(), String> {
        let Self { at, path, range, caption, .. } = self;
        if path.is_empty() {
            return Err(format!("The code on {at} says no file that it is from."));
        }
        if self.rust && !path.starts_with("steps/") {
            return Err(format!(
                "The Rust on {at} is from {path}, not from a step."
            ));
        }
        let source = source.ok_or(format!(
            "The listing on {at} is from {path}, which is no file."
        ))?;
        let source: Vec<&str> = source.lines().collect();
        let total = source.len();
        let within =
            |&(first, last): &_| 0 < first && first <= last && last <= total;
        let (first, last) = self.lines().filter(within).ok_or(format!(
            "The listing on {at} is lines {range} of {path}, which has {total}."
        ))?;
        let right = right_caption(path, first, last, total);
        if *caption != right {
            return Err(format!(
                "The caption of the listing on {at} is {caption:?}, not {right:?}."
            ));
        }
        self.compare(first, &source[first - 1..last])
    }

    /// Compares it with the lines of its file, from the line `first` on.
    fn compare(&self, first: usize, source: &[&str]) -> Result<(), String> {
        let Self { at, path, .. } = self;
        let code: Vec<_> = self.code.split('\n').collect();
        let differs = |&k: &usize| code.get(k) != source.get(k);
        match (0..code.len().max(source.len())).find(differs) {
            None => Ok(()),
            Some(k) => Err(format!(
                "The listing on {at} has {:?} for line {} of {path}, {:?}.",
                code.get(k).unwrap_or(&"nothing"),
                first + k,
                source.get(k).unwrap_or(&"nothing"),
            )),
        }
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
