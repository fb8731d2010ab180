//! Chapters and tests by hand agree: a chapter names, below its numbers, each test in
//! `tests/by_hand.rs` of its step.

use super::assert_no_faults;
use super::built_book::built_book;
use super::reader_workspace::STEP_NAMES;
use super::source_listings::SOURCE_FILES;
use std::collections::BTreeSet;

#[test]
fn chapters_name_every_test_by_hand() {
    let (book, mut faults) = (built_book(), vec![]);
    for step in STEP_NAMES {
        let page = &book.pages[&format!("{step}.html")];
        let elements = page.select_all(".by-hand").into_iter();
        let ids = elements.filter_map(|element| element.attr("id"));
        let page_tests: BTreeSet<_> =
            ids.filter_map(|id| id.strip_prefix("by-hand-")).collect();
        let path = format!("steps/{step}/tests/by_hand.rs");
        let file = SOURCE_FILES.text(&path).unwrap_or_default();
        let functions = file.split("#[test]\nfn ").skip(1);
        let file_tests: BTreeSet<_> =
            functions.filter_map(|function| function.split('(').next()).collect();
        for test in page_tests.symmetric_difference(&file_tests) {
            let page = &page.name;
            faults.push(format!("{test} is in only one of {path} and {page}."));
        }
    }
    assert_no_faults(&faults);
}
