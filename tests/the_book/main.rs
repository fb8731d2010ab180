//! Tests of what the book promises, on the HTML that a reader opens.
//!
//! The book is built once for all of these tests. The build itself fails if a chapter can't be
//! expanded, if a picture isn't a locked one or has no alternative text, if a link is broken, or if
//! a page would fetch anything from elsewhere.

mod built_book;
mod page_items;
mod reader_workspace;

// The code that the book shows is the code of the steps.
mod code_names;
mod source_listings;

// Every exercise and every figure is in the book.
mod exercises;
mod shown_figures;

// A reader or a class needs nothing but the book.
mod crate_states;
mod github_workflow;
mod own_scene;
mod typed_book;

/// Panics if there are any faults, and prints all of them.
#[track_caller]
fn assert_no_faults(faults: &[String]) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}
