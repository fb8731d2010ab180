use crate::files::resolve_path;
use crate::{Files, Page};
use anyhow::{Context, Result, ensure};

/// Puts into a page, instead of links to them, the styles that are among the `files` of
/// the book, so that it is shown at once.
pub fn inline_stylesheets(page: &mut Page, files: &Files) -> Result<()> {
    let links = page.select_all("link[rel=stylesheet]");
    ensure!(!links.is_empty(), "{} has no styles", page.name);
    let mut styles = String::new();
    for link in &links {
        let path = link.attr("href").unwrap_or_default();
        let css = files.text(path);
        styles += &rebase_urls(css.with_context(|| format!("there is no {path}"))?, path);
    }
    let links: Vec<_> = links.iter().map(|link| link.id()).collect();
    page.insert_html_before(links[0], &format!("<style>\n{styles}</style>"));
    links.into_iter().for_each(|link| page.remove_node(link));
    Ok(())
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
