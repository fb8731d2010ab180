use crate::{chapter, generated_files, problem};
use anyhow::{Context, Result, bail};
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::path::Path;

/// The preprocessor of the chapters: expands directives, and writes what they show beside
/// the chapters.
pub struct Course;

impl Preprocessor for Course {
    /// The name that it has in `book.toml`, so that `cargo run` takes this one in place of
    /// the command there.
    fn name(&self) -> &str {
        "course"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let workspace = context.root.parent().context("the book is in a workspace")?;
        generated_files::write_generated_files(workspace)?;
        let url = context.config.get::<String>("output.html.git-repository-url")?;
        expand_chapters(&mut book, workspace, &our_folder_markdown(workspace, url.as_deref()))?;
        Ok(book)
    }
}

/// Turns the chapters as they are written into plain Markdown.
fn expand_chapters(book: &mut Book, workspace: &Path, our_folder: &str) -> Result<()> {
    let chapters = book.chapters().map(|c| (&c.name[..], &c.content[..]));
    let sheet = problem::sheet_markdown(chapters);
    let texts: Vec<_> = book.chapters().map(|c| c.content.clone()).collect();
    let expanded = texts.par_iter().map(|text| {
        let text = text.replace("{{#our-folder}}", our_folder);
        let text = text.replace("{{#problem-sheet}}", &sheet);
        chapter::expand_directives(&text, workspace)
    });
    let expanded: Vec<_> = expanded.collect();
    let mut expanded = expanded.into_iter();
    let mut faults = vec![];
    book.for_each_chapter_mut(|chapter| {
        let Some((markdown, wrong)) = expanded.next() else { return };
        chapter.content = markdown;
        let file = chapter.source_path.clone().unwrap_or_default();
        faults.extend(
            wrong.iter().map(|(line, what)| format!("book/src/{}:{line}: {what}", file.display())),
        );
    });
    fail_with_faults(&faults)
}

/// The place of our folder, for a sentence: a book that is published has a link to it, one
/// that is built at home was built in it.
fn our_folder_markdown(workspace: &Path, url: Option<&str>) -> String {
    match url {
        Some(url) => format!("at [{url}]({url}): get it with `git clone {url}`"),
        None => format!("where this book was built: `{}`", workspace.display()),
    }
}

/// An error that tells all faults at once, if there are any; it stops the build.
pub fn fail_with_faults(faults: &[String]) -> Result<()> {
    let all: String = faults.iter().map(|fault| format!("{fault}\n")).collect();
    match faults.len() {
        0 => Ok(()),
        1 => bail!("{all}The book is not done: one fault."),
        many => bail!("{all}The book is not done: {many} faults."),
    }
}
