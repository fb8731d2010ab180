use super::assert_no_faults;
use super::support::reader_workspace::{STEP_NAMES, step_of_page};
use anyhow::Result;
use builder::{Files, Page, Site, inner_text};
use course::{target_folder, workspace};
use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::ffi::OsString;
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::mem;
use std::path::Path;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

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

/// Reads the book, which one process builds for all: a file beside it has the hash of what it
/// was made from.
fn read_or_build() -> Result<Site> {
    let folder = target_folder().join("tests/book");
    fs::create_dir_all(folder.with_file_name(""))?;
    let lock = File::create(folder.with_extension("reading"))?;
    lock.lock_shared()?;
    let (hash_file, mut hash) = (folder.with_extension("hash"), hash_sources()?);
    let is_built = |hash: &str| fs::read_to_string(&hash_file).is_ok_and(|built| built == hash);
    if !is_built(&hash) {
        lock.unlock()?;
        lock.lock()?;
    }
    while !is_built(&hash) {
        fs::write(&hash_file, "")?;
        builder::build(&workspace(), &folder)?;
        let old_hash = mem::replace(&mut hash, hash_sources()?);
        // Where a file was edited in the meantime, it is built again.
        if hash == old_hash {
            fs::write(&hash_file, &hash)?;
        }
    }
    let files = Files::read(&folder)?;
    let pages = files.texts_with_suffix(".html");
    let pages = pages.map(|(name, html)| (name.to_owned(), Page::parse(name, html))).collect();
    Ok(Site { files, pages })
}

/// The hash of what a book is made from: this program, the files of the workspace, and the
/// settings of mdBook in the environment.
fn hash_sources() -> Result<String> {
    let (mut hasher, program) = (DefaultHasher::new(), fs::metadata(env::current_exe()?)?);
    (program.modified()?, program.len(), workspace()).hash(&mut hasher);
    let is_setting = |name: &OsString| name.to_string_lossy().starts_with("MDBOOK_");
    let settings: BTreeMap<_, _> = env::vars_os().filter(|(name, _)| is_setting(name)).collect();
    settings.hash(&mut hasher);
    hash_folder(&workspace(), &mut hasher)?;
    Ok(format!("{:016x}", hasher.finish()))
}

/// Hashes the files in a folder, but for what is hidden, built or installed.
fn hash_folder(folder: &Path, hasher: &mut DefaultHasher) -> Result<()> {
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    for path in entries.collect::<Result<BTreeSet<_>>>()? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_source = !["target", "node_modules"].contains(&&*name);
        if !is_source || name.starts_with('.') || path == target_folder() {
            continue;
        }
        if path.is_dir() {
            hash_folder(&path, hasher)?;
        } else {
            (&path, fs::read(&path).ok()).hash(hasher);
        }
    }
    Ok(())
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
