use crate::{Files, Page};
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
    /// The pages in reading order, as the list of contents has them.
    ///
    /// `index.html` is not one of them: it is the first page again.
    pub fn chapters(&self) -> Vec<&Page> {
        let contents = self.pages["index.html"].all("#contents a");
        let names = contents.iter().filter_map(|link| link.attr("href"));
        names.filter_map(|name| self.pages.get(name)).collect()
    }

    /// How many elements that a CSS selector names are in the chapters.
    pub fn count(&self, selector: &str) -> usize {
        self.chapters().iter().map(|page| page.all(selector).len()).sum()
    }
}
