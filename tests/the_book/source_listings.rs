//! Every line of every source file is listed in a chapter of its step, once.

use super::assert_no_faults;
use super::built_book::{built_book, read_folder};
use super::support::listing::{join_listings, page_listings};
use super::support::reader_workspace::{STEP_NAMES, step_of_page};
use builder::Files;
use std::sync::LazyLock;

/// The files that a reader types, by path: those of the five crates, with their settings of
/// rustfmt, of `book/reader`, where a class begins, and of `book/typed`.
pub static SOURCE_FILES: LazyLock<Files> = LazyLock::new(|| {
    let steps = read_folder("steps").0.into_iter();
    let steps = steps.map(|(path, bytes)| (format!("steps/{path}"), bytes));
    let mut files: Files = Files(steps.collect());
    files.0.extend(read_folder("book/reader").0);
    files.0.extend(read_folder("book/typed").0);
    files
});

/// Whether several pages may list parts of a file: the benchmark measures what comes
/// later, the rest of a manifest comes with it, a list of modules grows from chapter to
/// chapter, and each step locks its picture.
fn may_be_on_several_pages(path: &str) -> bool {
    let parts = ["/Cargo.toml", "/benches/", "/src/lib.rs", "steps/locked/"];
    parts.iter().any(|part| path.contains(part))
}

/// The first of the pages that list a file has all of it; that of a crate is in its step.
#[test]
fn every_line_of_every_file_is_listed_once() {
    let (book, mut faults) = (built_book(), vec![]);
    let chapters = book.chapters_in_order().into_iter();
    let listings = chapters.flat_map(|page| page_listings(page).map(|one| (&*page.name, one)));
    let listings: Vec<_> = listings.collect();
    for (path, text) in SOURCE_FILES.texts_with_suffix("") {
        let mut parts = path.split('/');
        let Some(step) = parts.next().filter(|part| *part == "steps").and(parts.next()) else {
            continue;
        };
        let may_be_on_any_page = path.contains("/examples/") || !STEP_NAMES.contains(&step);
        let (pages, listings): (Vec<_>, Vec<_>) =
            listings.iter().filter(|(_, one)| one.path == path).cloned().unzip();
        let is_home = |page: &&&str| may_be_on_any_page || step_of_page(page) == Some(step);
        let home_page = pages.iter().find(is_home);
        let others = pages.iter().filter(|page| Some(*page) != home_page);
        for page in others.filter(|_| !may_be_on_several_pages(path)) {
            faults.push(format!("{page} lists a part of {path}, and should not."));
        }
        let listed = join_listings(&listings);
        if listed != text {
            let pairs = text.lines().zip(listed.lines());
            let equal_count = pairs.take_while(|(line, listed)| line == listed).count();
            faults.push(format!("Line {} of {path} is not listed once.", equal_count + 1));
        }
    }
    assert_no_faults(&faults);
}
