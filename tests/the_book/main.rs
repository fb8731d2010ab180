//! What the book promises, checked in the HTML that a reader opens.
//!
//! The book is built once for all of it: a build fails where a chapter can't be expanded,
//! a link leads nowhere, or anything would be fetched from elsewhere.

mod built;

// The book is the source.
mod listing;
mod source;

// The picture is the output.
mod pictures;

// The book suffices.
mod own_scene;
mod reading;
mod typed;
mod typist;

// What is worked out by hand holds, and what is predicted.
mod by_hand;
mod predicted;

mod pages;

/// Fails if there are faults, and tells all of them.
#[track_caller]
fn assert_none(faults: &[String]) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}
