use crate::files::CHAPTERS;
use crate::preprocessor::{Course, fail_with_faults};
use crate::sources::{GENERATED, Sources};
use crate::{Files, Page, Site, inline_stylesheets, links, paper_page, search};
use anyhow::{Context, Result};
use mdbook_driver::MDBook;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scraper::Html;
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
    // What a killed build left.
    let _ = fs::remove_dir_all(&draft);
    let built = write_and_check_pages(workspace, folder, &draft);
    let placed = built
        .and_then(|site| replace_folder(folder, &draft, &around.join("book.old")).map(|()| site));
    let _ = fs::remove_dir_all(&draft);
    placed
}

/// Moves the folder `new` to `folder`, and removes the one that was there once it is.
fn replace_folder(folder: &Path, new: &Path, old: &Path) -> Result<()> {
    let _ = fs::rename(folder, old);
    let moved = fs::rename(new, folder);
    if moved.is_err() {
        let _ = fs::rename(old, folder);
    }
    let _ = fs::remove_dir_all(old);
    moved.with_context(|| format!("{} can't be replaced", folder.display()))
}

/// Writes all pages into `folder`, with the help of the `old` ones. A fault in a chapter stops
/// it before any page is written; a link that leads nowhere is found when all are.
fn write_and_check_pages(workspace: &Path, old: &Path, folder: &Path) -> Result<Site> {
    let sources = Arc::new(Sources::read(workspace, &old.join(GENERATED))?);
    let mut book = MDBook::load(workspace.join("book")).context("no book")?;
    book.config.build.build_dir = folder.to_owned();
    book.with_preprocessor(Course(sources.clone()));
    book.build()?;
    let folder = book.build_dir_for("html");
    sources.generated.write(&folder.join(GENERATED))?;
    let mut files = Files::read(&folder)?;
    let html: Vec<_> = files.texts_with_suffix(".html").collect();
    let pages = html.into_par_iter().map(|(name, html)| {
        let mut page = Page::parse(name, html);
        finish_page(&mut page, &files)?;
        let html = page.html.html();
        fs::write(folder.join(name), &html).with_context(|| name.to_owned())?;
        Ok((page, html))
    });
    let mut site = Site { files: Files::default(), pages: Default::default() };
    for (page, html) in pages.collect::<Result<Vec<_>>>()? {
        files.0.insert(page.name.clone(), html.into_bytes());
        site.pages.insert(page.name.clone(), page);
    }
    let index = search::index_script(&site);
    fs::write(folder.join(search::INDEX), &index)?;
    files.0.insert(search::INDEX.to_owned(), index.into_bytes());
    site.files = files;
    let chapters = Files::read(&workspace.join(CHAPTERS))?;
    fail_with_faults(&links::find_faults(&site, &chapters))?;
    Ok(site)
}

/// Finishes a page that mdBook has written.
fn finish_page(page: &mut Page, files: &Files) -> Result<()> {
    // mdBook puts the title of a part into an item of its own, and HTML has no such item.
    page.replace_each("li:empty", |_| String::new());
    page.replace_each("a:has(> math)", name_formula_link);
    match page.name.as_str() {
        "toc.html" => return Ok(()),
        "print.html" => paper_page::arrange_for_paper(page)?,
        _ => {}
    }
    inline_stylesheets::inline_stylesheets(page, files)
}

/// A link with a name for screen readers where it is a formula alone.
fn name_formula_link(html: &str) -> String {
    let inside = html.split_once('>').map_or("", |(_, inside)| inside);
    let is_formula = inside.starts_with("<math")
        && inside.ends_with("</math></a>")
        && inside.matches("<math").count() == 1;
    let link = Html::parse_fragment(html);
    let letters: String = link.root_element().text().collect();
    let name = format!("<a aria-label=\"{}\" ", letters.trim());
    if is_formula { html.replacen("<a ", &name, 1) } else { html.to_owned() }
}
