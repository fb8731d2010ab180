use crate::{Course, Files, Site, fault, link, paper};
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
    let print = folder.join("print.html");
    let paper = paper::pressed(&fs::read_to_string(&print)?);
    fs::write(print, paper)?;
    let site = Site::new(Files::read(&folder)?);
    fault::check(&link::faults(&site))?;
    Ok((folder, site))
}
