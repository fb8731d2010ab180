use crate::Files;
use anyhow::Result;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use scraper::{ElementRef, Html, Selector};
use std::collections::BTreeMap;
use std::path::Path;

/// The book as a reader gets it.
#[derive(Clone, Debug)]
pub struct Site {
    /// Every file of it.
    pub files: Files,
    /// Every page of it, by the name of its file.
    pub pages: BTreeMap<String, Page>,
}

impl Site {
    /// Reads a book that was built into a folder.
    pub fn read(folder: &Path) -> Result<Self> {
        let files = Files::read(folder)?;
        let texts: Vec<_> = files.texts_with_suffix(".html").collect();
        let pages = texts.into_par_iter();
        let pages = pages.map(|(name, html)| (name.to_owned(), Page::parse(name, html))).collect();
        Ok(Self { files, pages })
    }

    /// The pages in reading order, as the list of contents has them.
    ///
    /// `index.html` is not one of them: it is the first page again.
    pub fn chapters_in_order(&self) -> Vec<&Page> {
        let contents = self.pages["index.html"].select_all("#contents a");
        let names = contents.iter().filter_map(|link| link.attr("href"));
        names.filter_map(|name| self.pages.get(name)).collect()
    }
}

/// A page of the book, as a browser reads it.
#[derive(Clone, Debug)]
pub struct Page {
    /// File name, such as `step01_rays.html`.
    pub name: String,
    /// Parsed tree of elements.
    pub html: Html,
}

impl Page {
    /// Reads the HTML of the page `name`.
    pub fn parse(name: &str, html: &str) -> Self {
        Self { name: name.to_owned(), html: Html::parse_document(html) }
    }

    /// Every element that a CSS selector names, from top to bottom.
    pub fn select_all(&self, selector: &str) -> Vec<ElementRef<'_>> {
        select_all(self.html.root_element(), selector)
    }

    /// Address of an element, for the sentence about a fault: its page, and the last id
    /// before it.
    pub fn address_for_fault(&self, element: ElementRef) -> String {
        let around = std::iter::once(*element).chain(element.ancestors());
        let mut ids_before = around
            .flat_map(|node| std::iter::once(node).chain(node.prev_siblings()))
            .filter_map(|node| node.value().as_element()?.id());
        ids_before.next().map_or(self.name.clone(), |id| format!("{}#{id}", self.name))
    }
}

/// Every element in another that a CSS selector names, from top to bottom.
pub fn select_all<'a>(element: ElementRef<'a>, selector: &str) -> Vec<ElementRef<'a>> {
    let selector = Selector::parse(selector).expect("a CSS selector");
    element.select(&selector).collect()
}

/// The text of an element, with that of the elements in it.
pub fn inner_text(element: ElementRef) -> String {
    element.text().collect()
}
