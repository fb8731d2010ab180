use crate::{Course, Files, Site, fault, finish, link, paper};
use anyhow::{Context, Result};
use mdbook_driver::MDBook;
use std::fs;
use std::path::{Component, Path, PathBuf, absolute};

/// Builds the book whose `book.toml` is in the folder `root`; returns the folder of
/// its pages, and what is in it.
///
/// A fault in a chapter stops it before any page is written. A link that leads
/// nowhere is found when all are.
pub fn build(root: &Path) -> Result<(PathBuf, Site)> {
    let root = absolute(root)?;
    let mut book = MDBook::load(&root)
        .with_context(|| format!("the book in {} can't be read", root.display()))?;
    // Replaces the preprocessor of the same name in book.toml, which is this
    // program again.
    book.with_preprocessor(Course);
    book.build()?;
    let mut folder = PathBuf::new();
    for part in book.build_dir_for("html").components() {
        match part {
            Component::ParentDir => drop(folder.pop()),
            part => folder.push(part),
        }
    }
    let mut files = Files::read(&folder)?;
    let mut pages = vec![];
    for (name, html) in files.texts(".html") {
        let html = match name {
            "print.html" => &paper::pressed(html),
            _ => html,
        };
        pages.push((name.to_owned(), finish::finished(html, &files)));
    }
    for (name, html) in pages {
        fs::write(folder.join(&name), &html)?;
        files.0.insert(name, html.into_bytes());
    }
    let site = Site::new(files);
    fault::check(&link::faults(&site))?;
    Ok((folder, site))
}
