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

/// The `html` of a page with the styles themselves in place of links to them, so that it is shown
/// at once. They are among the `files` of the book; an address in one counts from its file.
pub fn inline_stylesheets(html: &str, files: &Files) -> Result<String, StylesheetError> {
    replace_between(html, "<link rel=\"stylesheet\" href=\"", "\">", |path| {
        let css = files.text(path).ok_or_else(|| StylesheetError::UnknownFile(path.to_owned()))?;
        let css = replace_between(css, "url(\"", "\"", |address| {
            Ok::<_, StylesheetError>(format!("url(\"{}\"", resolve_path(path, address)))
        })?;
        Ok(format!("<style>\n{css}</style>"))
    })
}
