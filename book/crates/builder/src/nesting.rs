//! Checks that the elements on every page are nested as HTML requires: an element ends before the
//! element around it does, and an element for text, such as a label, contains no blocks.
//!
//! A browser doesn't report wrong nesting. The browser guesses what was meant, and its guess may be
//! wrong.

use crate::Site;
use crate::page::{is_void, tokens};
use html5ever::tokenizer::{TagKind, Token};
use thiserror::Error;

/// Elements that may contain text and inline elements, but no blocks.
const TEXT_ELEMENTS: [&str; 23] = [
    "b", "button", "cite", "code", "del", "em", "h1", "h2", "h3", "h4", "i", "ins", "kbd", "label",
    "option", "output", "p", "pre", "small", "span", "strong", "sub", "sup",
];

/// Elements that are blocks.
const BLOCK_ELEMENTS: [&str; 28] = [
    "article",
    "aside",
    "blockquote",
    "dd",
    "details",
    "dialog",
    "div",
    "dl",
    "dt",
    "figure",
    "footer",
    "form",
    "h1",
    "h2",
    "h3",
    "h4",
    "header",
    "hr",
    "li",
    "main",
    "nav",
    "ol",
    "p",
    "pre",
    "section",
    "summary",
    "table",
    "ul",
];

/// A misplaced tag, and where it is.
#[derive(Debug, Error)]
#[error("{page}:{line}: {error}")]
pub struct NestingFault {
    page: String,
    /// The line in the finished page.
    line: u64,
    error: NestingError,
}

/// Everything that can be wrong with a tag.
#[derive(Debug, Error, PartialEq)]
enum NestingError {
    #[error("</{end}> is inside <{open}>, which isn't closed")]
    Unclosed { end: String, open: String },
    #[error("</{0}> closes nothing")]
    ClosesNothing(String),
    #[error("<{0}> is never closed")]
    NeverClosed(String),
    #[error("<{inner}> isn't allowed inside <{outer}>")]
    Misplaced { inner: String, outer: String },
    #[error("{0}")]
    Syntax(String),
}

/// Finds the misplaced tags on all pages.
pub fn find_faults(site: &Site) -> Vec<NestingFault> {
    let pages = site.files.texts_with_suffix(".html");
    let faults = pages.flat_map(|(page, html)| {
        misplaced_tags(html).into_iter().map(|(line, error)| NestingFault {
            page: page.to_owned(),
            line,
            error,
        })
    });
    faults.collect()
}

/// Finds the misplaced tags on a page. Each error comes with its line number.
fn misplaced_tags(html: &str) -> Vec<(u64, NestingError)> {
    let (mut errors, mut open) = (vec![], Vec::<String>::new());
    let mut last_line = 0;
    for (token, line) in tokens(html) {
        last_line = line;
        match token {
            Token::TagToken(tag) if tag.kind == TagKind::StartTag => {
                let name = tag.name.to_string();
                let outer = open.iter().find(|outer| TEXT_ELEMENTS.contains(&&***outer));
                if let Some(outer) = outer.filter(|_| BLOCK_ELEMENTS.contains(&&*name)) {
                    let (inner, outer) = (name.clone(), outer.clone());
                    errors.push((line, NestingError::Misplaced { inner, outer }));
                }
                if name == "li" && open.last().is_some_and(|outer| outer == "li") {
                    let (inner, outer) = (name.clone(), name.clone());
                    errors.push((line, NestingError::Misplaced { inner, outer }));
                }
                if !tag.self_closing && !is_void(&name) {
                    open.push(name);
                }
            }
            Token::TagToken(tag) => {
                let end = tag.name.to_string();
                match open.iter().rposition(|name| *name == end) {
                    Some(level) => {
                        if let Some(inner) = open.get(level + 1) {
                            let open = inner.clone();
                            errors.push((line, NestingError::Unclosed { end, open }));
                        }
                        open.truncate(level);
                    }
                    None => errors.push((line, NestingError::ClosesNothing(end))),
                }
            }
            Token::ParseError(error) => {
                errors.push((line, NestingError::Syntax(error.into_owned())));
            }
            _ => {}
        }
    }
    errors.extend(open.into_iter().map(|name| (last_line, NestingError::NeverClosed(name))));
    errors
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list_errors(html: &str) -> Vec<String> {
        misplaced_tags(html).into_iter().map(|(line, error)| format!("{line}: {error}")).collect()
    }

    #[test]
    fn well_nested_page_has_no_faults() {
        let html = "<!DOCTYPE html><ul><li><p>a<br>b</p></li></ul><svg><path d=\"\"/></svg>\
                    <script>if (a < b) \"</p>\";</script>";
        assert_eq!(list_errors(html), [""; 0]);
    }

    #[test]
    fn misplaced_tags_are_found_with_their_lines() {
        for (html, error) in [
            ("<ul><li>\n<li>a</li></li></ul>", ["2: <li> isn't allowed inside <li>"].as_slice()),
            ("<p>\n<b>a</p>", &["2: </p> is inside <b>, which isn't closed"]),
            ("<p>a</p></p>", &["1: </p> closes nothing"]),
            ("<div>", &["1: <div> is never closed"]),
            ("<span>\n<div></div></span>", &["2: <div> isn't allowed inside <span>"]),
        ] {
            assert_eq!(list_errors(&format!("<!DOCTYPE html>{html}")), error, "{html}");
        }
        assert!(!list_errors("<p =a>b</p>").is_empty());
    }
}
