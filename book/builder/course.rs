use crate::draft::{self, Chapter};
use crate::fault::{self, Fault};
use crate::files::CHAPTERS;
use crate::pictures;
use anyhow::{Context, Result};
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf, absolute};

/// The preprocessor of this book: turns the chapters as they are written into plain
/// Markdown.
#[derive(Clone, Copy, Debug)]
pub struct Course;

impl Preprocessor for Course {
    fn name(&self) -> &str {
        "course"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let root = absolute(&context.root)?;
        let workspace =
            root.parent().context("the book is a folder of a workspace")?;
        pictures::write(workspace)?;
        let url = context.config.get::<String>("output.html.git-repository-url")?;
        let ours = our_folder(workspace, url.as_deref());
        let chapters: Vec<_> = book.chapters().collect();
        let expanded = chapters.par_iter().filter_map(|chapter| {
            let text = chapter.content.replace("{{#our-folder}}", &ours);
            let expanded = draft::expand(&text, workspace);
            Some((chapter.source_path.clone()?, expanded))
        });
        let expanded: BTreeMap<PathBuf, Chapter> = expanded.collect();
        let mut faults = vec![];
        book.for_each_chapter_mut(|chapter| {
            let Some(path) = &chapter.source_path else { return };
            let Some(expanded) = expanded.get(path) else { return };
            chapter.content.clone_from(&expanded.markdown);
            let file = format!("{CHAPTERS}{}", path.display());
            let fault = |(line, what)| Fault { file: file.clone(), line, what };
            faults.extend(expanded.faults.iter().cloned().map(fault));
            if path.components().count() != 1 {
                let what = "a chapter stands in the folder of the chapters itself";
                faults.push(fault((1, what.to_string())));
            }
        });
        fault::check(&faults)?;
        Ok(book)
    }
}

/// Where the reader finds our folder: a book that is published has a link to it, one
/// that is built at home was built in it.
pub fn our_folder(workspace: &Path, url: Option<&str>) -> String {
    match url {
        Some(url) => format!("at [{url}]({url}): get it with `git clone {url}`"),
        None => format!("where this book was built: `{}`", workspace.display()),
    }
}

/// Answers the mdbook program, which writes a book to our input and reads it from
/// our output.
pub fn answer() -> Result<()> {
    let (context, book) = mdbook_preprocessor::parse_input(io::stdin())?;
    serde_json::to_writer(io::stdout(), &Course.run(&context, book)?)?;
    Ok(())
}
