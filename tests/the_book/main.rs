//! What the book promises, checked in the HTML that a reader opens.
//!
//! Each module is one promise: the check, a test that the book keeps it, and tests
//! that a fault is found. The book is built once for all of them.

mod built;

mod listing;
mod source;

mod own_scene;
mod reading;
mod typed;
mod typist;

mod link;

mod face;
mod locked;
mod markup;

mod by_hand;
mod item;
mod lecture;
mod notation;

mod prose;

mod rust;

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
