use super::assert_no_faults;
use super::support::reader_workspace::{STEP_NAMES, step_of_page};
use builder::{Files, Site, inner_text};
use course::{target_folder, workspace};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::{fs, process};

/// The book, built by the first test that needs it; one test reads it at a time.
pub fn built_book() -> MutexGuard<'static, Site> {
    static BOOK: LazyLock<Result<Mutex<Site>, String>> = LazyLock::new(|| {
        let folder = target_folder().join(format!("tests/book-{}", process::id()));
        let site = builder::build(&workspace(), &folder);
        let _ = fs::remove_dir_all(folder);
        site.map(Mutex::new).map_err(|error| format!("{error:#}"))
    });
    let book = BOOK.as_ref().unwrap_or_else(|fault| panic!("{fault}"));
    book.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Reads the files in a folder of the workspace.
pub fn read_folder(folder: &str) -> Files {
    let files = Files::read(&workspace().join(folder));
    files.unwrap_or_else(|error| panic!("{folder}: {error}"))
}

#[test]
fn chapters_of_the_steps_are_in_order() {
    let book = built_book();
    let chapters = book.chapters_in_order().into_iter();
    let names = chapters.map(|page| page.name.as_str());
    let (steps, chapters): (Vec<_>, Vec<_>) =
        names.filter_map(|name| Some((step_of_page(name)?, name))).unzip();
    assert!(steps.is_sorted(), "{chapters:?}");
    for step in STEP_NAMES {
        let first = steps.iter().position(|name| *name == step);
        let first = first.map(|index| chapters[index]);
        assert_eq!(first, Some(&*format!("{step}.html")));
    }
}

#[test]
fn titles_of_pages_are_those_in_the_contents() {
    let book = built_book();
    let mut faults = vec![];
    for link in book.pages["index.html"].select_all("#contents a") {
        let name = link.attr("href").unwrap_or_default();
        // The title of the introduction is the book's.
        let Some(page) = book.pages.get(name).filter(|_| name != "introduction.html") else {
            continue;
        };
        let titles = page.select_all("h1").into_iter().map(inner_text);
        let title = inner_text(link);
        if !titles.map(|text| text.trim().to_owned()).any(|text| text == title.trim()) {
            faults.push(format!("{name} is called {title:?} in the contents."));
        }
    }
    assert_no_faults(&faults);
}
