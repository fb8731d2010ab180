use crate::Course;
use anyhow::{Context, Result};
use mdbook_driver::MDBook;
use mdbook_driver::book::BookItem;
use std::path::{Path, PathBuf};

/// What a build made.
#[derive(Debug)]
pub struct Built {
    /// The folder of the HTML files.
    pub folder: PathBuf,
    /// How many chapters the book has.
    pub chapters: usize,
    /// How many listings there are in them.
    pub listings: usize,
    /// How many figures.
    pub figures: usize,
    /// How many pictures.
    pub pictures: usize,
    /// How many formulas.
    pub formulas: usize,
}

/// Builds the book whose `book.toml` is in the folder `root`.
///
/// A mistake in a chapter is an error that names its file and line; then nothing is
/// written.
pub fn build(root: &Path) -> Result<Built> {
    let course = Course::default();
    let mut book = MDBook::load(root)
        .with_context(|| format!("the book in {} can't be read", root.display()))?;
    // Replaces the preprocessor of the same name in book.toml, which is this
    // program again.
    book.with_preprocessor(course.clone());
    book.build()?;
    let folder = book.build_dir_for("html");
    Ok(Built {
        folder: folder.canonicalize().unwrap_or(folder),
        chapters: book
            .iter()
            .filter(|item| matches!(item, BookItem::Chapter(_)))
            .count(),
        listings: course.count(|page| page.listings),
        figures: course.count(|page| page.figures),
        pictures: course.count(|page| page.pictures),
        formulas: course.count(|page| page.formulas),
    })
}
