//! Every link, anchor and picture leads to something in the book, and nothing is
//! fetched from elsewhere.

use super::built::BOOK;
use super::{assert_found, assert_none};
use book::Site;

/// The faults that a build tells.
fn faults(book: &Site) -> Vec<String> {
    book::faults(book).iter().map(ToString::to_string).collect()
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
        let words = ["step01_rays.html:", what];
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
        assert_found(&faults(&book), &["fonts/fonts.css:2", what]);
    }
}

#[test]
fn a_missing_file_is_found() {
    let mut book = BOOK.clone();
    book.files.0.remove("fonts/literata.woff2");
    // Each page asks for it.
    let faults = faults(&book);
    let words = "fonts/literata.woff2, which is not in the book";
    assert!(BOOK.chapters().len() < faults.len());
    assert!(faults.iter().all(|fault| fault.contains(words)), "{faults:#?}");
}
