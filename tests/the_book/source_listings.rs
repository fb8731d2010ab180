//! Every line of every source file is listed in a chapter of its step, once.

use super::assert_no_faults;
use super::built_book::{built_book, read_folder};
use super::support::listing::{Listing, page_listings};
use super::support::reader_workspace::{STEP_NAMES, step_of_page};
use builder::Files;
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
        let listings: Vec<_> = listings.iter().filter(|(_, one)| one.path == path).collect();
        let mut pages = listings.iter().map(|(page, _)| *page);
        let home_page = pages.find(|page| may_be_on_any_page || step_of_page(page) == Some(step));
        let mut listing_counts = vec![0; text.lines().count()];
        for (page, Listing { location, lines: (first, last), .. }) in listings {
            if Some(*page) != home_page && !may_be_on_several_pages(path) {
                faults.push(format!("{location}: {path} is of {}.", home_page.unwrap_or(step)));
            }
            listing_counts[first - 1..*last].iter_mut().for_each(|count| *count += 1);
        }
        let mut counts = (1..).zip(listing_counts);
        if let Some((line, count)) = counts.find(|(_, count)| *count != 1) {
            faults.push(format!("Line {line} of {path} is listed {count} times."));
        }
    }
    assert_no_faults(&faults);
}
