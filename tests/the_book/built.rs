use book::{Files, Site};
use compare::{target_folder, workspace};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::{fs, process};

/// Our book, built now, in a folder of this process; one test reads it at a time.
pub fn book() -> MutexGuard<'static, Site> {
    static BOOK: LazyLock<Mutex<Site>> = LazyLock::new(|| {
        let folder = target_folder().join(format!("tests/book-{}", process::id()));
        let built = book::build(&workspace(), &folder);
        let _ = fs::remove_dir_all(folder);
        Mutex::new(built.unwrap_or_else(|error| panic!("{error:#}")))
    });
    BOOK.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The files in a folder of the workspace.
pub fn files(folder: &str) -> Files {
    let files = Files::read(&workspace().join(folder));
    files.unwrap_or_else(|error| panic!("{folder}: {error}"))
}

#[test]
fn the_steps_are_chapters_in_their_order() {
    let book = book();
    let names = book.chapters().into_iter().map(|page| &page.name[..]);
    let steps = names.filter_map(|name| name.strip_suffix(".html"));
    let steps: Vec<_> = steps.filter(|name| name.starts_with("step")).collect();
    assert_eq!(steps, super::typist::STEPS);
}
