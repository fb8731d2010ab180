use crate::fault::Faults;
use crate::files::CHAPTERS;
use crate::sources::{GENERATED, Sources};
use crate::{chapter, problem};
use anyhow::Result;
use mdbook_preprocessor::book::Book;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use std::path::Path;
use std::sync::Arc;

/// The preprocessor of the chapters: expands directives.
pub struct Course(pub Arc<Sources>);

impl Course {
    /// Reads what the chapters of a workspace show, and writes beside them what mdBook copies
    /// from there.
    pub fn beside_chapters(workspace: &Path) -> Result<Self> {
        let folder = workspace.join(CHAPTERS).join(GENERATED);
        let sources = Sources::read(workspace)?;
        sources.generated.write(&folder)?;
        Ok(Self(sources.into()))
    }
}

impl Preprocessor for Course {
    /// The name that it has in `book.toml`, so that `cargo run` takes this one in place of
    /// the command there.
    fn name(&self) -> &str {
        "course"
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        // A book that is published has a link to our folder. One built at home was built in it, but
        // may be copied elsewhere, so it doesn't name it.
        let our_folder = match context.config.get::<String>("output.html.git-repository-url")? {
            Some(url) => format!("at [{url}]({url}): get it with `git clone {url}`"),
            None => {
                "where this book was built, the folder with `steps` and `book` in it".to_owned()
            }
        };
        expand_chapters(&mut book, &self.0, &our_folder)?;
        Ok(book)
    }
}

/// Turns the chapters as they are written into plain Markdown.
fn expand_chapters(book: &mut Book, sources: &Sources, our_folder: &str) -> Result<()> {
    let chapters = book.chapters().map(|c| (&c.name[..], &c.content[..]));
    let sheet = problem::sheet_markdown(chapters);
    let (sheet, sheet_faults) = chapter::expand_directives(&sheet, sources, "");
    let mut faults = vec![];
    book.for_each_chapter_mut(|chapter| {
        let text = chapter.content.replace("{{#our-folder}}", our_folder);
        let (markdown, wrong) = chapter::expand_directives(&text, sources, &sheet);
        chapter.content = markdown;
        let file = chapter.source_path.clone().unwrap_or_default();
        faults.extend(wrong.iter().map(|fault| format!("{CHAPTERS}{}:{fault}", file.display())));
    });
    // A fault of a problem is told in its chapter alone.
    if faults.is_empty() {
        faults
            .extend(sheet_faults.iter().map(|fault| format!("the problem sheet: {}", fault.error)));
    }
    Ok(Faults::ensure_none(faults)?)
}
