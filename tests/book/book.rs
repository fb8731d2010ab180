use crate::files::Files;
use crate::page::Page;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

/// The book as a reader gets it.
#[derive(Clone, Debug)]
pub struct Book {
    /// Every file of it.
    pub files: Files,
    /// Every page of it, by the name of its file.
    pub pages: BTreeMap<String, Page>,
}

/// Our book, built now.
pub static BOOK: LazyLock<Book> = LazyLock::new(|| {
    let built = book::build(&workspace().join("book"));
    let built = built.unwrap_or_else(|error| panic!("{error:#}"));
    Book::new(Files::read(&built.folder))
});

/// The root of the workspace.
pub fn workspace() -> &'static Path {
    let book = Path::new(env!("CARGO_MANIFEST_DIR"));
    book.parent().expect("book is a folder of the workspace")
}

impl Book {
    fn new(files: Files) -> Self {
        let pages = files
            .texts(".html")
            .map(|(name, html)| (name.to_string(), Page::new(name, html)))
            .collect();
        Self { files, pages }
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

#[test]
fn the_steps_are_chapters_in_their_order() {
    let chapters = BOOK.chapters();
    let steps = chapters.iter().filter(|page| page.name.starts_with("step"));
    let names: Vec<_> = steps.map(|page| page.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "step01_rays.html",
            "step02_sphere.html",
            "step03_nearest.html",
            "step04_diffuse.html",
            "step05_phong.html"
        ]
    );
    let first = |name: &str| BOOK.pages[name].all("main").next().map(|m| &m.text);
    assert_eq!(first("index.html"), first(&chapters[0].name));
}
