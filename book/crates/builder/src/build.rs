use crate::inline_stylesheets::inline_stylesheets;
use crate::preprocessor::{Course, fail_with_faults};
use crate::sources::{GENERATED, Sources};
use crate::{Files, Site, links, picture, search};
use anyhow::{Context, Error, Result};
use mdbook_driver::MDBook;
use std::fs::{self, File};
use std::path::Path;
use std::sync::Arc;

/// Builds the book of a workspace into `folder`, one at a time; returns what is in it.
///
/// Writes it beside the folder and puts it in place when it is complete, so that a fault
/// leaves the book that was there.
pub fn build(workspace: &Path, folder: &Path) -> Result<Site> {
    let around = folder.parent().context("the book has a folder of its own")?;
    fs::create_dir_all(around).with_context(|| format!("{} can't be made", around.display()))?;
    let lock = File::create(around.join("book.lock"))
        .with_context(|| format!("{} can't be written", around.display()))?;
    lock.lock()?;
    let draft = around.join("book.draft");
    // What a build with a fault left, or a killed one.
    let _ = fs::remove_dir_all(&draft);
    let site = write_and_check_pages(workspace, &draft)?;
    let _ = fs::remove_dir_all(folder);
    fs::rename(&draft, folder)
        .with_context(|| format!("{} can't be replaced", folder.display()))?;
    Ok(site)
}

/// Writes all pages into `folder`. A fault in a chapter stops it before any page is written; a
/// link that leads nowhere is found when all are.
fn write_and_check_pages(workspace: &Path, folder: &Path) -> Result<Site> {
    let sources = Arc::new(Sources::read(workspace)?);
    let mut book = MDBook::load(workspace.join("book")).context("no book")?;
    book.config.build.build_dir = folder.to_owned();
    book.with_preprocessor(Course(sources.clone()));
    book.build()?;
    let folder = book.build_dir_for("html");
    sources.generated.write(&folder.join(GENERATED))?;
    let files = Files::read(&folder)?;
    for (name, html) in files.texts_with_suffix(".html") {
        let mut html = inline_stylesheets(html, &files)
            .map_err(Error::msg)
            .with_context(|| name.to_owned())?;
        if name == "print.html" {
            // A picture that waits to be seen would not be on paper.
            html = html.replace(picture::LAZY, "");
        }
        fs::write(folder.join(name), html).with_context(|| name.to_owned())?;
    }
    let site = Site::read(&folder)?;
    fs::write(folder.join("search-index.js"), search::index_script(&site)?)?;
    fail_with_faults(&links::find_faults(&site))?;
    Ok(site)
}
