//! Tests that the HTML that a reader opens keeps the book's promises.
//!
//! The book is built once for all of these tests. The build itself fails
//!
//! - if a chapter can't be expanded,
//! - if a picture isn't locked, or has no alternative text,
//! - if a link is broken,
//! - if a page would fetch anything from outside the book.

mod built_book;
mod page_items;
mod reader_workspace;

// These modules test that the book shows the code of the steps.
mod code_names;
mod source_listings;

// These modules test that every exercise and every figure is in the book.
mod exercises;
mod shown_figures;

// These modules test that a reader or a class needs nothing but the book.
mod crate_states;
mod github_workflow;
mod own_scene;
mod typed_book;

/// If there are any faults, panics with all of them.
#[track_caller]
fn assert_no_faults(faults: &[String]) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}
