//! What the book promises, checked in the HTML that a reader opens.
//!
//! Each module is one promise: the check, a test that the book keeps it, and tests
//! that a fault is found. The book is built once for all of them.

mod book;
mod element;
mod files;
mod page;

mod listing;
mod source;

mod reader;
mod typed;

mod link;
mod style;

mod markup;
mod picture;

mod table;

mod item;
mod lecture;
mod notation;
mod slides;

mod prose;

/// Fails if there are faults, and tells all of them.
#[track_caller]
fn assert_none(faults: &[String]) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// Fails unless there is one fault, and the sentence about it holds all `words`.
#[track_caller]
fn assert_found(faults: &[String], words: &[&str]) {
    let [fault] = faults else { panic!("not one fault: {faults:#?}") };
    for word in words {
        assert!(fault.contains(word), "no {word:?} in: {fault}");
    }
}
