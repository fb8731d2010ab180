//! What tests the book, what `check` says, and what answers in the pages: one program,
//! so that while one test waits for Cargo, others go on.

mod book;
#[path = "check/tests/mod.rs"]
mod check;
mod live;
