use crate::Files;
use crate::files::resolve_path;
use anyhow::{Context, Result};

/// The `html` of a page with the styles themselves in place of links to them, so that it is shown
/// at once. They are among the `files` of the book.
pub fn inline_stylesheets(html: &str, files: &Files) -> Result<String> {
    let mut parts = html.split("<link rel=\"stylesheet\" href=\"");
    let mut inlined = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (path, rest) = part.split_once("\">").context("a link to a style has no end")?;
        let css = files.text(path).with_context(|| format!("there is no {path}"))?;
        inlined += &format!("<style>\n{}</style>{rest}", rebase_urls(css, path));
    }
    Ok(inlined)
}

/// The style from the file `path` for a page: its addresses count from there.
fn rebase_urls(css: &str, path: &str) -> String {
    let mut parts = css.split("url(\"");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |css, part| {
        let (address, css_after) = part.split_once('"').unwrap_or((part, ""));
        css + "url(\"" + &resolve_path(path, address) + "\"" + css_after
    })
}
