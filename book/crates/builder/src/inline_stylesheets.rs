//! Copies stylesheets into the pages that link to them.

use crate::Files;
use crate::files::resolve_path;
use crate::replace_between::{MissingEnd, replace_between};
use thiserror::Error;

/// What can be wrong with a link to a stylesheet.
#[derive(Debug, Error)]
pub enum StylesheetError {
    #[error(transparent)]
    MissingEnd(#[from] MissingEnd),
    #[error("there is no {0}")]
    UnknownFile(String),
}

/// In the `html` of a page, replaces each link to a stylesheet with the text of that stylesheet, so
/// that a browser can show the page without waiting for further files. `files` contains the
/// stylesheets. Comments in a stylesheet are left out, since each page would repeat them. Addresses
/// in a stylesheet are relative to the stylesheet, so the addresses are rewritten to be relative to
/// the page.
pub fn inline_stylesheets(html: &str, files: &Files) -> Result<String, StylesheetError> {
    replace_between(html, "<link rel=\"stylesheet\" href=\"", "\">", |path| {
        let css = files.text(path).ok_or_else(|| StylesheetError::UnknownFile(path.to_owned()))?;
        let css = replace_between(css, "/*", "*/", |_| Ok::<_, StylesheetError>(String::new()))?;
        let css = replace_between(&css, "url(\"", "\"", |address| {
            Ok::<_, StylesheetError>(format!("url(\"{}\"", resolve_path(path, address)))
        })?;
        let lines = css.lines().map(str::trim_end).filter(|line| !line.is_empty());
        Ok(format!("<style>\n{}\n</style>", lines.collect::<Vec<_>>().join("\n")))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inline(html: &str) -> Result<String, StylesheetError> {
        let css =
            "/* Two\n   lines. */\na { src: url(\"b.woff2\"); }\n\nb { top: 0; } /* A word. */\n";
        inline_stylesheets(html, &Files([("css/a.css".to_owned(), css.into())].into()))
    }

    #[test]
    fn stylesheet_without_its_comments_replaces_its_link() {
        let html = inline("<link rel=\"stylesheet\" href=\"css/a.css\">text")
            .expect("the stylesheet exists");
        assert_eq!(html, "<style>\na { src: url(\"css/b.woff2\"); }\nb { top: 0; }\n</style>text");
    }

    #[test]
    fn link_to_a_missing_stylesheet_is_an_error() {
        let error = inline("<link rel=\"stylesheet\" href=\"b.css\">")
            .expect_err("there is no such stylesheet");
        assert_eq!(error.to_string(), "there is no b.css");
    }
}
