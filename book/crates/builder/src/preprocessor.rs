//! The preprocessor that mdBook calls to expand the chapters.

use crate::fault::{Fault, Faults};
use crate::files::CHAPTERS;
use crate::sources::{GENERATED, Sources};
use crate::{chapter, problem};
use anyhow::Result;
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use std::collections::BTreeMap;
use std::mem;
use std::path::Path;
use std::sync::Arc;

/// The preprocessor that expands the directives of all chapters.
#[derive(Debug)]
pub struct ChapterPreprocessor(pub Arc<Sources>);

impl ChapterPreprocessor {
    /// Reads the sources of a workspace. Writes the generated files to a folder beside the
    /// chapters, from which mdBook copies them into the book.
    pub fn read_sources_and_write_generated(workspace: &Path) -> Result<Self> {
        let folder = workspace.join(CHAPTERS).join(GENERATED);
        let sources = Sources::read(workspace)?;
        sources.generated.sync_to(&folder)?;
        Ok(Self(sources.into()))
    }
}

impl Preprocessor for ChapterPreprocessor {
    /// The preprocessor's name in book/book.toml. That file also gives the preprocessor's command,
    /// which `mdbook serve` runs. In `cargo run`, mdBook finds this object by the same name, and
    /// calls the object instead of the command.
    fn name(&self) -> &str {
        "course"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        // A published book links to the repository. Any other book only describes the folder with
        // the source. The folder's path would be wrong on another computer.
        let source_location_markdown =
            match context.config.get::<String>("output.html.git-repository-url")? {
                Some(url) => format!("at [{url}]({url}): get it with `git clone {url}`"),
                None => {
                    "where this book was built, the folder with `steps` and `book` in it".to_owned()
                }
            };
        expand_chapters(&mut book, &self.0, &source_location_markdown)?;
        Ok(book)
    }
}

/// Expands all chapters in place, or returns an error that lists the faults of all chapters.
fn expand_chapters(
    book: &mut Book,
    sources: &Sources,
    source_location_markdown: &str,
) -> Result<()> {
    let (mut chapters, mut problems, mut faults) = (BTreeMap::new(), vec![], vec![]);
    for chapter in book.chapters() {
        let mut expanded =
            chapter::expand_chapter(&chapter.content, sources, source_location_markdown);
        let file = chapter.source_path.as_deref().unwrap_or(Path::new(""));
        let in_file = |fault: &Fault| format!("{CHAPTERS}{}:{fault}", file.display());
        faults.extend(expanded.faults.iter().map(in_file));
        problems.push((chapter.name.clone(), mem::take(&mut expanded.problems)));
        chapters.insert(chapter.path.clone(), expanded);
    }
    Faults::ensure_none(faults)?;
    let sheet = problem::sheet_markdown(&problems, &sources.values)?;
    book.for_each_chapter_mut(|chapter| {
        if let Some(expanded) = chapters.get(&chapter.path) {
            chapter.content = expanded.markdown_with_sheet(&sheet);
        }
    });
    Ok(())
}
