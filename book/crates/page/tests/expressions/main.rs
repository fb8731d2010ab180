//! An edited line draws what the reader's own program would draw. If Rust would refuse the line, it
//! is refused here.

mod drawn_in_steps;
mod judged_by_rustc;
mod lines;
mod listed_mistakes;
