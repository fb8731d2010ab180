use crate::mistake::{Mistake, Mistakes};
use crate::page::{self, House, Page};
use crate::{link, picture};
use anyhow::{Context, Result};
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// The preprocessor of this book: turns the chapters as they are written into plain
/// Markdown.
#[derive(Clone, Debug, Default)]
pub struct Course {
    pages: Arc<Mutex<BTreeMap<PathBuf, Page>>>,
}

impl Course {
    /// The sum over all pages of what `count` finds in one; 0 before the book is
    /// built.
    pub fn count(&self, count: impl Fn(&Page) -> usize) -> usize {
        self.pages.lock().map_or(0, |pages| pages.values().map(count).sum())
    }
}

impl Preprocessor for Course {
    fn name(&self) -> &str {
        "course"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let root = context.root.canonicalize()?;
        let house = House {
            workspace: root
                .parent()
                .context("the book is a folder of a workspace")?
                .to_path_buf(),
            chapters: root.join(&context.config.book.src),
        };
        picture::copy_snapshots(&house)?;
        let chapters: Vec<_> = book.chapters().collect();
        let expanded = chapters.par_iter().filter_map(|chapter| {
            let page = page::expand(&chapter.content, &house);
            Some((chapter.source_path.clone()?, page))
        });
        let pages: BTreeMap<PathBuf, Page> = expanded.collect();
        book.for_each_chapter_mut(|chapter| {
            let page =
                chapter.source_path.as_ref().and_then(|path| pages.get(path));
            if let Some(page) = page {
                chapter.content.clone_from(&page.markdown);
            }
        });
        let mistakes = mistakes(&pages, &house);
        if !mistakes.is_empty() {
            return Err(Mistakes(mistakes).into());
        }
        if let Ok(mut kept) = self.pages.lock() {
            *kept = pages;
        }
        Ok(book)
    }
}

/// Every mistake of every page, its links included.
fn mistakes(pages: &BTreeMap<PathBuf, Page>, house: &House) -> Vec<Mistake> {
    let by_path: BTreeMap<&Path, &Page> =
        pages.iter().map(|(p, page)| (p.as_path(), page)).collect();
    let mut mistakes = vec![];
    for (path, page) in pages {
        let broken = page.links.iter().filter_map(|(line, target)| {
            Some((*line, link::check(target, path, &by_path, &house.chapters)?))
        });
        let mut found: Vec<_> =
            page.mistakes.iter().cloned().chain(broken).collect();
        if path.components().count() != 1 {
            found.push((
                1,
                "a chapter stands in the folder of the chapters itself".to_string(),
            ));
        }
        found.sort();
        let file = house.name(&house.chapters.join(path));
        let mistake = |(line, what)| Mistake { file: file.clone(), line, what };
        mistakes.extend(found.into_iter().map(mistake));
    }
    mistakes
}

/// Answers the mdbook program, which writes a book to our input and reads it from
/// our output.
pub fn answer() -> Result<()> {
    let (context, book) = mdbook_preprocessor::parse_input(io::stdin())?;
    let book = Course::default().run(&context, book)?;
    serde_json::to_writer(io::stdout(), &book)?;
    Ok(())
}
