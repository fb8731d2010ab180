//! The book, built once for all tests.

use anyhow::Result;
use builder::{Files, Site};
use course::environment::nextest_run_id;
use course::{target_folder, workspace};
use std::fs::{self, File};
use std::sync::LazyLock;

/// The book, or the reason why it can't be built.
static BOOK: LazyLock<Result<Site>> = LazyLock::new(build_book_once_per_run);

#[test]
fn book_is_built() {
    if let Err(fault) = &*BOOK {
        panic!("{fault:#}");
    }
}

/// Returns the built book, exactly as a reader gets it.
pub fn built_book() -> &'static Site {
    BOOK.as_ref()
        .unwrap_or_else(|_| panic!("the book is not built: the test book_is_built says why"))
}

/// Builds the book. Under nextest, each test runs in its own process, so the first test builds the
/// book, and the other tests read the built book.
fn build_book_once_per_run() -> Result<Site> {
    let folder = target_folder().join("tests/book");
    let Some(run) = nextest_run_id() else {
        return builder::build(&workspace(), &folder);
    };
    let run_file = folder.with_extension("run");
    fs::create_dir_all(folder.with_file_name(""))?;
    let lock = File::create(folder.with_extension("reading"))?;
    lock.lock()?;
    if fs::read_to_string(&run_file).ok().as_ref() != Some(&run) {
        builder::build(&workspace(), &folder)?;
        fs::write(run_file, run)?;
    }
    Site::read(&folder)
}

/// Reads all files in a folder of the workspace.
pub fn read_workspace_folder(folder: &str) -> Files {
    let files = Files::read(&workspace().join(folder));
    files.unwrap_or_else(|error| panic!("{folder}: {error}"))
}
