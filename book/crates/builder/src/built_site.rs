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
    pub fn chapters_in_order(&self) -> Vec<&Page> {
        let contents = self.pages["index.html"].select_all("#contents a");
        let names = contents.iter().filter_map(|link| link.attr("href"));
        names.filter_map(|name| self.pages.get(name)).collect()
    }
}
