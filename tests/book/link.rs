//! Every link, anchor and picture leads to something in the book, and nothing is
//! fetched from elsewhere.

use crate::book::{BOOK, Book};
use crate::element::Element;
use crate::style::urls;
use crate::{assert_found, assert_none};

/// Each link that leads nowhere, and all that would be fetched from elsewhere.
fn faults(book: &Book) -> Vec<String> {
    let mut faults = vec![];
    for page in book.pages.values() {
        for element in &page.elements {
            for address in addresses(element) {
                let leads_out = element.tag == "a" && is_elsewhere(address);
                if let Err(what) = resolve(book, &page.name, address)
                    && !leads_out
                {
                    faults.push(format!(
                        "Line {} of {} {what}.",
                        element.line, page.name
                    ));
                }
            }
        }
    }
    for (name, css) in book.files.texts(".css") {
        for (line, css) in css.lines().enumerate() {
            for address in urls(css) {
                if let Err(what) = resolve(book, name, address) {
                    faults.push(format!("Line {} of {name} {what}.", line + 1));
                }
            }
        }
    }
    faults
}

/// Everything that an element leads to or loads.
fn addresses(element: &Element) -> Vec<&str> {
    if element.tag == "base" {
        // Says where the book is, and fetches nothing.
        return vec![];
    }
    let names = ["href", "src", "xlink:href", "poster", "data", "action"];
    let mut found: Vec<_> =
        names.iter().filter_map(|name| element.get(name)).collect();
    let sets = element.get("srcset").into_iter().flat_map(|set| set.split(','));
    found.extend(sets.filter_map(|one| one.split_whitespace().next()));
    found.extend(element.get("style").into_iter().flat_map(urls));
    if element.tag == "style" {
        found.extend(urls(&element.text));
    }
    found
}

/// Whether an address names another place than the book.
fn is_elsewhere(address: &str) -> bool {
    let scheme = address.split(['/', '#', '?']).next().unwrap_or_default();
    address.starts_with('/') || scheme.contains(':')
}

/// Says what is wrong with an address in the file `from`, if it is not that of
/// something in the book.
fn resolve(book: &Book, from: &str, address: &str) -> Result<(), String> {
    if address.starts_with("data:") {
        return Ok(());
    }
    if is_elsewhere(address) {
        return Err(format!("fetches {address} from outside the book"));
    }
    let (path, id) = address.split_once('#').unwrap_or((address, ""));
    let path = match path.split('?').next().unwrap_or_default() {
        "" => from.to_string(),
        path => joined(from, path),
    };
    if !book.files.0.contains_key(&path) {
        return Err(format!("leads to {path}, which is not in the book"));
    }
    let has = |id| {
        book.pages.get(&path)?.elements.iter().find(|e| e.get("id") == Some(id))
    };
    if id.is_empty() || has(id).is_some() {
        return Ok(());
    }
    Err(format!("leads to #{id}, which is not in {path}"))
}

/// The path to which `path` leads from the file `from`.
fn joined(from: &str, path: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." if !parts.is_empty() => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[test]
fn everything_resolves_and_nothing_is_fetched_from_elsewhere() {
    assert_none(&faults(&BOOK));
}

#[test]
fn a_broken_link_is_found() {
    for (html, what) in [
        ("<a href=\"nowhere.html\">a</a>", "leads to nowhere.html"),
        ("<a href=\"../index.html\">a</a>", "leads to ../index.html"),
        (
            "<a href=\"#nowhere\">a</a>",
            "#nowhere, which is not in step01_rays.html",
        ),
        (
            "<a href=\"index.html#nowhere\">a</a>",
            "#nowhere, which is not in index.html",
        ),
        ("<img src=\"pictures/nowhere.png\" alt=\"a\">", "pictures/nowhere.png"),
    ] {
        let words = ["Line ", "step01_rays.html", what];
        assert_found(&faults(&BOOK.with_html(html)), &words);
    }
    assert_none(&faults(&BOOK.with_html("<a href=\"https://a.example/b\">a</a>")));
}

#[test]
fn what_is_fetched_from_elsewhere_is_found() {
    for html in [
        "<script src=\"https://a.example/b\"></script>",
        "<link rel=\"stylesheet\" href=\"http://a.example/b\">",
        "<img src=\"//a.example/b\" alt=\"a\">",
        "<img srcset=\"https://a.example/b 2x\" alt=\"a\">",
        "<p style=\"background: url('https://a.example/b')\"></p>",
        "<style>@import \"https://a.example/b\";</style>",
    ] {
        let words = ["step01_rays.html", "a.example/b from outside"];
        assert_found(&faults(&BOOK.with_html(html)), &words);
    }
    let font = "url(\"literata.woff2\")";
    for (css, what) in [
        ("url(https://a.example/b)", "a.example/b from outside"),
        ("url(\"nowhere.woff2\")", "leads to fonts/nowhere.woff2"),
    ] {
        let book = BOOK.with("fonts/fonts.css", font, css);
        assert_found(&faults(&book), &["Line 2 of fonts/fonts.css", what]);
    }
}

#[test]
fn a_missing_file_is_found() {
    let mut book = BOOK.clone();
    book.files = book.files.without("fonts/literata.woff2");
    assert_found(
        &faults(&book),
        &["fonts/literata.woff2, which is not in the book"],
    );
}
