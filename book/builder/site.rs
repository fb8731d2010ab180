use crate::{Files, Page};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::collections::BTreeMap;

/// The book as a reader gets it.
#[derive(Clone, Debug)]
pub struct Site {
    /// Every file of it.
    pub files: Files,
    /// Every page of it, by the name of its file.
    pub pages: BTreeMap<String, Page>,
}

impl Site {
    /// Reads the pages among the files.
    pub fn new(files: Files) -> Self {
        let texts: Vec<_> = files.texts(".html").collect();
        let pages = texts.into_par_iter();
        let pages =
            pages.map(|(name, html)| (name.to_string(), Page::new(name, html)));
        Self { pages: pages.collect(), files }
    }

    /// The pages in reading order, as the list of contents has them.
    ///
    /// `index.html` is not one of them: it is the first page again.
    pub fn chapters(&self) -> Vec<&Page> {
        let index = &self.pages["index.html"];
        let contents = index.all("a").filter(|link| {
            index.around(link).any(|nav| nav.get("id") == Some("contents"))
        });
        let names = contents.filter_map(|link| link.get("href"));
        names.filter_map(|name| self.pages.get(name)).collect()
    }

    /// How many elements of this name and class the chapters have.
    pub fn count(&self, tag: &str, class: &str) -> usize {
        let elements = self.chapters().into_iter().flat_map(|page| &page.elements);
        elements
            .filter(|one| {
                one.tag == tag && (class.is_empty() || one.is(tag, class))
            })
            .count()
    }

    /// This book, with `from` replaced by `to` where it first stands in a file.
    #[track_caller]
    pub fn with(&self, name: &str, from: &str, to: &str) -> Self {
        let files = self.files.with(name, from, to);
        let mut pages = self.pages.clone();
        if let Some(page) = pages.get_mut(name) {
            *page = Page::new(name, files.text(name).unwrap_or_default());
        }
        Self { files, pages }
    }

    /// This book, with a piece of HTML at the end of the text of step 1.
    #[track_caller]
    pub fn with_html(&self, html: &str) -> Self {
        self.with("step01_rays.html", "</main>", &format!("{html}</main>"))
    }
}
