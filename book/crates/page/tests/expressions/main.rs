//! Tests that an edited line draws what the reader's own program would draw, and that a page
//! refuses a line if Rust would refuse it.

mod drawn_in_steps;
mod judged_by_rustc;
mod lines;
mod listed_mistakes;
