//! Chapters and tests by hand agree: those of a step name, below their numbers, each test in
//! its `tests/by_hand.rs`.

use super::assert_no_faults;
use super::built_book::built_book;
use super::source_listings::SOURCE_FILES;
use super::support::reader_workspace::pages_of_step;
use course::Step;
use std::collections::BTreeSet;

#[test]
fn chapters_name_every_test_by_hand() {
    let (book, mut faults) = (built_book(), vec![]);
    for step in Step::NAMES {
        let elements = pages_of_step(&book, step).flat_map(|page| page.select_all(".by-hand"));
        let ids = elements.filter_map(|element| element.attr("id"));
        let page_tests: BTreeSet<_> = ids.filter_map(|id| id.strip_prefix("by-hand-")).collect();
        let path = format!("steps/{step}/tests/by_hand.rs");
        let file = SOURCE_FILES.text(&path).unwrap_or_default();
        let functions = file.split("#[test]\nfn ").skip(1);
        let file_tests: BTreeSet<_> =
            functions.filter_map(|function| function.split('(').next()).collect();
        for test in page_tests.symmetric_difference(&file_tests) {
            faults.push(format!("{test} is in only one of {path} and the chapters of {step}."));
        }
    }
    assert_no_faults(&faults);
}
