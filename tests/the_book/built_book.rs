use super::assert_no_faults;
use anyhow::Result;
use builder::{Files, Page, Site, inner_text};
use course::{target_folder, workspace};
use std::env;
use std::fs::{self, File};
use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::time::SystemTime;

/// The book, or the fault for which it can't be built; one test reads it at a time.
static BOOK: LazyLock<Result<Mutex<Site>>> = LazyLock::new(|| read_or_build().map(Mutex::new));

#[test]
fn book_is_built() {
    if let Err(fault) = &*BOOK {
        panic!("{fault:#}");
    }
}

/// The book as its reader opens it.
pub fn built_book() -> MutexGuard<'static, Site> {
    let book = BOOK.as_ref().unwrap_or_else(|_| panic!("see the test book_is_built"));
    book.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Reads the book, which one process builds for all, where it is older than what it is made from.
fn read_or_build() -> Result<Site> {
    let folder = target_folder().join("tests/book");
    fs::create_dir_all(folder.with_file_name(""))?;
    let lock = File::create(folder.with_extension("reading"))?;
    lock.lock()?;
    let time_file = folder.with_extension("time");
    let source_time = newest_change(&workspace())?.max(newest_change(&env::current_exe()?)?);
    if fs::metadata(&time_file).and_then(|file| file.modified()).ok() <= Some(source_time) {
        let start = SystemTime::now();
        builder::build(&workspace(), &folder)?;
        File::create(time_file)?.set_modified(start)?;
    }
    lock.unlock()?;
    lock.lock_shared()?;
    let files = Files::read(&folder)?;
    let pages = files.texts_with_suffix(".html");
    let pages = pages.map(|(name, html)| (name.to_owned(), Page::parse(name, html))).collect();
    Ok(Site { files, pages })
}

/// The time of the last change of a file, or of any in a folder and of those in it, but for what
/// is hidden, built or installed.
fn newest_change(path: &Path) -> Result<SystemTime> {
    let mut newest = fs::metadata(path)?.modified()?;
    for entry in fs::read_dir(path).into_iter().flatten() {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_made = ["target", "node_modules"].contains(&&*name) || path == target_folder();
        if !is_made && !name.starts_with('.') {
            newest = newest.max(newest_change(&path)?);
        }
    }
    Ok(newest)
}

pub fn read_folder(folder: &str) -> Files {
    let files = Files::read(&workspace().join(folder));
    files.unwrap_or_else(|error| panic!("{folder}: {error}"))
}

#[test]
fn titles_of_pages_are_those_in_the_contents() {
    let book = built_book();
    let mut faults = vec![];
    for link in book.pages["index.html"].select_all("#contents a") {
        let (name, title) = (link.attr("href").unwrap_or_default(), inner_text(link));
        let mut titles = book.pages[name].select_all("h1").into_iter().map(inner_text);
        // The title of the introduction is the book's.
        if name != "introduction.html" && !titles.any(|text| text.trim() == title.trim()) {
            faults.push(format!("{name} is called {title:?} in the contents."));
        }
    }
    assert_no_faults(&faults);
}
