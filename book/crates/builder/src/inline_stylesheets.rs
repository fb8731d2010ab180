use crate::Files;
use crate::files::resolve_path;
use crate::replace_between::replace_between;

/// The `html` of a page with the styles themselves in place of links to them, so that it is shown
/// at once. They are among the `files` of the book; an address in one counts from its file.
pub fn inline_stylesheets(html: &str, files: &Files) -> Result<String, String> {
    replace_between(html, "<link rel=\"stylesheet\" href=\"", "\">", |path| {
        let css = files.text(path).ok_or(format!("there is no {path}"))?;
        let css = replace_between(css, "url(\"", "\"", |address| {
            Ok(format!("url(\"{}\"", resolve_path(path, address)))
        })?;
        Ok(format!("<style>\n{css}</style>"))
    })
}
