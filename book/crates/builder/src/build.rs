//! The whole build: a draft of the book is written and checked, and then replaces the old book.

use crate::fault::Faults;
use crate::inline_stylesheets::inline_stylesheets;
use crate::preprocessor::ChapterPreprocessor;
use crate::replace_between::{MissingEnd, replace_between};
use crate::sources::{GENERATED, Sources};
use crate::{Files, Site, links, nesting, picture, search};
use anyhow::{Context, Result, ensure};
use mdbook_driver::MDBook;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Builds the book of a workspace into `folder`. Returns the files and pages of the book.
///
/// A lock file makes concurrent builds wait for each other. The pages are written to a draft beside
/// `folder`. The draft replaces `folder` only after all checks, so a fault leaves the old book in
/// place.
pub fn build(workspace: &Path, folder: &Path) -> Result<Site> {
    let parent = folder.parent().context("the book needs a folder of its own")?;
    fs::create_dir_all(parent).with_context(|| format!("{} can't be created", parent.display()))?;
    let lock = open_lock(&parent.join("book.lock"))?;
    lock.lock()?;
    restore_folder_and_remove_old_versions(folder)?;
    let draft = parent.join("book.draft");
    // If an earlier build was killed or found a fault, its draft may still be there.
    let _ = fs::remove_dir_all(&draft);
    let site = write_and_check_pages(workspace, &draft)?;
    replace_folder(&draft, folder)
        .with_context(|| format!("{} can't be replaced", folder.display()))?;
    Ok(site)
}

/// Opens the lock file without changing its contents, or creates the file. Returns an error if
/// anything but a regular file is at this path. Even a symbolic link is an error, because the link
/// could lead to a file in another folder.
fn open_lock(path: &Path) -> Result<File> {
    let is_other = fs::symlink_metadata(path).is_ok_and(|metadata| !metadata.is_file());
    ensure!(!is_other, "{} isn't a regular file; remove it", path.display());
    let lock = File::options().write(true).create(true).truncate(false).open(path);
    lock.with_context(|| format!("{} can't be opened", path.display()))
}

/// Returns the paths to which the old version of a folder may be moved. The paths are beside the
/// folder. There are several paths, because some may be taken: an old version can't be removed
/// while a program has it open.
fn old_version_paths(folder: &Path) -> impl Iterator<Item = PathBuf> {
    (1..=9).map(|number| folder.with_extension(format!("old{number}")))
}

/// If a killed build has moved a folder aside, moves the folder back. Removes all other old
/// versions of the folder.
fn restore_folder_and_remove_old_versions(folder: &Path) -> Result<()> {
    for old_version in old_version_paths(folder).filter(|path| path.exists()) {
        if folder.exists() {
            let _ = fs::remove_dir_all(old_version);
        } else {
            fs::rename(&old_version, folder)
                .with_context(|| format!("{} can't be put back", old_version.display()))?;
        }
    }
    Ok(())
}

/// Replaces a folder with a draft. The old folder is moved aside first and removed last.
fn replace_folder(draft: &Path, folder: &Path) -> io::Result<()> {
    if !folder.exists() {
        return fs::rename(draft, folder);
    }
    let free = old_version_paths(folder).find(|path| !path.exists());
    let old_version =
        free.ok_or_else(|| io::Error::other("there are too many old versions beside it"))?;
    fs::rename(folder, &old_version)?;
    if let Err(error) = fs::rename(draft, folder) {
        let _ = fs::rename(&old_version, folder);
        return Err(error);
    }
    // If the old version can't be removed now, the next build tries again.
    let _ = fs::remove_dir_all(old_version);
    Ok(())
}

/// Writes all pages into `folder`, and checks the pages. A fault in a chapter stops the build
/// before any page is written. Links and tags are checked once all pages exist.
fn write_and_check_pages(workspace: &Path, folder: &Path) -> Result<Site> {
    let sources = Arc::new(Sources::read(workspace)?);
    let mut book = MDBook::load(workspace.join("book")).context("the book can't be loaded")?;
    book.config.build.build_dir = folder.to_owned();
    book.with_preprocessor(ChapterPreprocessor(sources.clone()));
    book.build()?;
    let folder = book.build_dir_for("html");
    sources.generated.sync_to(&folder.join(GENERATED))?;
    let mut files = Files::read(&folder)?;
    for (name, html) in postprocess_pages(&files)? {
        write_page_file(&folder, &mut files, name, html)?;
    }
    let mut site = Site::parse(files);
    let index = search::index_script(&site, search::READER_WORDS)?;
    write_page_file(&folder, &mut site.files, "search-index.js".to_owned(), index)?;
    Faults::ensure_none(links::find_address_faults(&site))?;
    Faults::ensure_none(nesting::find_faults(&site))?;
    Ok(site)
}

/// Completes the pages that mdBook has written. Returns the name and final HTML of each page.
fn postprocess_pages(files: &Files) -> Result<Vec<(String, String)>> {
    let pages = files.texts_with_suffix(".html").map(|(name, html)| {
        let html = unwrap_part_titles(html).with_context(|| name.to_owned())?;
        let mut html = inline_stylesheets(&html, files).with_context(|| name.to_owned())?;
        if name == "print.html" {
            html = picture::remove_lazy_loading(&html);
        }
        Ok((name.to_owned(), html))
    });
    pages.collect()
}

/// Repairs the titles of the book's parts in the table of contents. mdBook wraps each title in two
/// list items, one directly inside the other. HTML doesn't allow such nesting, so only the inner
/// list item is kept.
fn unwrap_part_titles(html: &str) -> Result<String, MissingEnd> {
    let begin = "<li class=\"chapter-item expanded \"><li class=\"part-title\">";
    replace_between(html, begin, "</li></li>", |title| {
        Ok(format!("<li class=\"part-title\">{title}</li>"))
    })
}

/// Writes a file into `folder`. Stores the same text in `files`, which is a copy of that folder in
/// memory.
fn write_page_file(folder: &Path, files: &mut Files, name: String, text: String) -> Result<()> {
    fs::write(folder.join(&name), &text).with_context(|| name.clone())?;
    files.0.insert(name, text.into_bytes());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{env, process};

    /// Creates a folder that contains a draft and an old book. Returns the paths of the folder, the
    /// draft and the old book.
    fn create_draft_and_old_book(name: &str) -> (PathBuf, PathBuf, PathBuf) {
        let parent = env::temp_dir().join(format!("{name}-{}", process::id()));
        let _ = fs::remove_dir_all(&parent);
        let (draft, book) = (parent.join("book.draft"), parent.join("book"));
        for (folder, text) in [(&draft, "new"), (&book, "old")] {
            fs::create_dir_all(folder).expect("the folder can be created");
            fs::write(folder.join("index.html"), text).expect("the file can be written");
        }
        (parent, draft, book)
    }

    fn read_index(book: &Path) -> String {
        fs::read_to_string(book.join("index.html")).unwrap_or_default()
    }

    #[test]
    fn part_title_is_a_single_list_item() {
        let html =
            "<ol><li class=\"chapter-item expanded \"><li class=\"part-title\">a</li></li></ol>";
        let closed = unwrap_part_titles(html).expect("the part title is closed");
        assert_eq!(closed, "<ol><li class=\"part-title\">a</li></ol>");
    }

    #[test]
    fn draft_takes_the_place_of_the_old_book() {
        let (parent, draft, book) = create_draft_and_old_book("replace_folder");
        replace_folder(&draft, &book).expect("the book can be replaced");
        assert_eq!(read_index(&book), "new");
        assert_eq!(fs::read_dir(&parent).expect("the folder can be read").count(), 1);
        fs::remove_dir_all(parent).expect("the folder can be removed");
    }

    #[test]
    fn old_book_is_put_back_if_replacing_it_fails() {
        let (parent, draft, book) = create_draft_and_old_book("no_draft");
        fs::remove_dir_all(&draft).expect("the draft can be removed");
        assert!(replace_folder(&draft, &book).is_err());
        assert_eq!(read_index(&book), "old");
        fs::remove_dir_all(parent).expect("the folder can be removed");
    }

    #[test]
    fn book_that_a_killed_build_moved_aside_is_restored() {
        let (parent, _, book) = create_draft_and_old_book("put_aside");
        fs::rename(&book, book.with_extension("old1")).expect("the book can be moved aside");
        restore_folder_and_remove_old_versions(&book).expect("the book can be moved back");
        assert_eq!(read_index(&book), "old");
        // If the book is in its place, old versions are removed.
        fs::create_dir_all(book.with_extension("old2")).expect("the folder can be created");
        restore_folder_and_remove_old_versions(&book).expect("old versions can be removed");
        assert!(!book.with_extension("old2").exists());
        // If a path for old versions is taken, `replace_folder` uses another path.
        fs::create_dir_all(book.with_extension("old1")).expect("the folder can be created");
        replace_folder(&parent.join("book.draft"), &book).expect("the book can be replaced");
        assert_eq!(read_index(&book), "new");
        fs::remove_dir_all(parent).expect("the folder can be removed");
    }

    #[test]
    fn lock_file_keeps_its_contents_and_may_not_be_a_link() {
        let (parent, _, book) = create_draft_and_old_book("lock");
        let lock = parent.join("book.lock");
        fs::write(&lock, "text").expect("the file can be written");
        open_lock(&lock).expect("the lock file can be opened");
        assert_eq!(fs::read_to_string(&lock).expect("the lock file can be read"), "text");
        assert!(open_lock(&book).is_err());
        #[cfg(unix)]
        {
            fs::remove_file(&lock).expect("the lock file can be removed");
            std::os::unix::fs::symlink(book.join("index.html"), &lock)
                .expect("the link can be created");
            assert!(open_lock(&lock).is_err());
            assert_eq!(read_index(&book), "old");
        }
        fs::remove_dir_all(parent).expect("the folder can be removed");
    }
}
