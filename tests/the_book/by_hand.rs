//! What a chapter works out by hand, the step's tests by hand hold: the chapter names each
//! of them below its numbers.

use super::assert_none;
use super::built::book;
use super::source::SOURCE;
use super::typist::STEPS;
use std::collections::BTreeSet;

#[test]
fn every_test_by_hand_is_named_in_its_chapter() {
    let (book, mut faults) = (book(), vec![]);
    for step in STEPS {
        let page = &book.pages[&format!("{step}.html")];
        let ids = page.all(".by-hand").into_iter().filter_map(|one| one.attr("id"));
        let named: BTreeSet<_> =
            ids.filter_map(|id| id.strip_prefix("by-hand-")).collect();
        let path = format!("steps/{step}/tests/by_hand.rs");
        let file = SOURCE.text(&path).unwrap_or_default();
        let tests = file.split("#[test]\nfn ").skip(1);
        let tests: BTreeSet<_> =
            tests.filter_map(|test| test.split('(').next()).collect();
        for test in named.symmetric_difference(&tests) {
            faults.push(format!("{test} is in one of {path} and {}.", page.name));
        }
    }
    assert_none(&faults);
}
