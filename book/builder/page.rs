use crate::reader::Reader;
use mdbook_markdown::pulldown_cmark::Options;
use std::path::{Path, PathBuf};

/// Where a page finds what it includes.
#[derive(Clone, Debug)]
pub struct House {
    /// The root of the workspace.
    pub workspace: PathBuf,
    /// The folder of the chapters.
    pub chapters: PathBuf,
}

impl House {
    /// How `path` reads from the root of the workspace, with / between its parts.
    pub fn name(&self, path: &Path) -> String {
        let path = path.strip_prefix(&self.workspace).unwrap_or(path);
        let parts =
            path.components().map(|part| part.as_os_str().to_string_lossy());
        parts.collect::<Vec<_>>().join("/")
    }
}

/// A chapter with everything in place, and what there is to check or to count in
/// it.
#[derive(Debug, Default)]
pub struct Page {
    /// Markdown that any program of mdBook's kind renders.
    pub markdown: String,
    /// Every link: the line it is on, and where it goes.
    pub links: Vec<(usize, String)>,
    /// Every id that a link can go to.
    pub ids: Vec<String>,
    /// What is wrong: the line, and what it is.
    pub mistakes: Vec<(usize, String)>,
    /// How many listings it has.
    pub listings: usize,
    /// How many figures it has.
    pub figures: usize,
    /// How many pictures it has.
    pub pictures: usize,
    /// How many formulas it has.
    pub formulas: usize,
}

/// Markdown as mdBook reads it, with formulas.
pub fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// Puts listings, formulas, figures, values, pictures and boxes into the `text` of
/// a chapter.
pub fn expand(text: &str, house: &House) -> Page {
    let mut reader = Reader::new(text, house);
    reader.events();
    reader.directives();
    reader.finish()
}
