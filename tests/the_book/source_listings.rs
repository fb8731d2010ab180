//! Every line of every source file is listed in a chapter of its step, once.

use super::assert_no_faults;
use super::built_book::{built_book, read_folder};
use super::support::listing::{Listing, page_listings};
use super::support::reader_workspace::{STEP_NAMES, step_of_page};
use builder::{Files, Site};
use course::workspace;
use std::fs;
use std::sync::LazyLock;

/// The files that a reader types, by path: those of the five crates, with their settings of
/// rustfmt, of `book/reader`, and the program that the page of the own scene writes.
pub static SOURCE_FILES: LazyLock<Files> = LazyLock::new(|| {
    let steps = read_folder("steps").0.into_iter();
    let steps = steps.map(|(path, bytes)| (format!("steps/{path}"), bytes));
    let mut files: Files = Files(steps.collect());
    files.0.extend(read_folder("book/reader").0);
    files
});

/// The name of the page that lists a file: the first that does, of its step; or, for an
/// example and a file of no step, of any. None for a file outside `steps/`.
fn home_page(book: &Site, path: &str) -> Option<String> {
    let (step, file) = path.strip_prefix("steps/")?.split_once('/')?;
    let may_be_on_any_page = file.starts_with("examples/") || !STEP_NAMES.contains(&step);
    let mut chapters = book.chapters_in_order().into_iter();
    let page = chapters.find(|page| {
        (may_be_on_any_page || step_of_page(&page.name) == Some(step))
            && page_listings(page).any(|listing| listing.path == path)
    });
    Some(page.map_or(format!("{step}.html"), |page| page.name.clone()))
}

/// Whether several pages may list parts of a file: the benchmark measures what comes
/// later, the rest of a manifest comes with it, a list of modules grows from chapter to
/// chapter, and each step locks its picture.
fn may_be_on_several_pages(path: &str) -> bool {
    let parts = ["/Cargo.toml", "/benches/", "/src/lib.rs", "steps/locked/"];
    parts.iter().any(|part| path.contains(part))
}

#[test]
fn listings_are_lines_of_their_files() {
    let (book, mut faults) = (built_book(), vec![]);
    for listing in book.chapters_in_order().into_iter().flat_map(page_listings) {
        let Listing { location, path, lines: (first, last), code } = listing;
        // `Cargo.toml` is the name of the reader's manifest and of the course's own.
        let course_file = fs::read_to_string(workspace().join(path)).ok();
        let reader_file = SOURCE_FILES.text(path);
        let Some(file) = reader_file
            .filter(|text| text.contains(&code))
            .or(course_file.as_deref())
            .or(reader_file)
        else {
            faults.push(format!("{location}: there is no file {path}."));
            continue;
        };
        let file_lines: Vec<_> = file.lines().collect();
        let file_lines = file_lines.get(first - 1..last).unwrap_or_default();
        if file_lines.join("\n") != code {
            let mut pairs = file_lines.iter().zip(code.lines());
            let equal_count = pairs.position(|(line, listed)| *line != listed).unwrap_or(0);
            let line = first + equal_count;
            faults.push(format!("{location}: line {line} of {path} differs."));
        }
    }
    assert_no_faults(&faults);
}

#[test]
fn code_outside_listings_is_not_rust() {
    let (book, mut faults) = (built_book(), vec![]);
    let selector = "figure:not(.listing) > pre code, :not(figure) > pre code";
    for page in book.chapters_in_order() {
        for code in page.select_all(selector) {
            let class = code.attr("class").unwrap_or_default();
            if class.is_empty() || class.contains("rust") {
                let location = page.address_for_fault(code);
                faults.push(format!("The code at {location} is from no file."));
            }
        }
    }
    assert_no_faults(&faults);
}

#[test]
fn every_line_of_every_file_is_listed_once() {
    let (book, mut faults) = (built_book(), vec![]);
    for (path, text) in SOURCE_FILES.texts_with_suffix("") {
        let Some(home_page) = home_page(&book, path) else { continue };
        let mut listing_counts = vec![0; text.lines().count()];
        for page in book.chapters_in_order() {
            for listing in page_listings(page) {
                if listing.path != path {
                    continue;
                }
                if page.name != home_page && !may_be_on_several_pages(path) {
                    let location = listing.location;
                    faults.push(format!("{location}: {path} is of {home_page}."));
                }
                let (first, last) = listing.lines;
                for count in &mut listing_counts[first - 1..last] {
                    *count += 1;
                }
            }
        }
        let mut counts = (1..).zip(listing_counts);
        if let Some((line, count)) = counts.find(|(_, count)| *count != 1) {
            faults.push(format!("Line {line} of {path} is listed {count} times in {home_page}."));
        }
    }
    assert_no_faults(&faults);
}
