//! Edited lines draw what the reader's own program would, and what Rust would refuse is refused.

mod drawn_in_steps;
mod judged_by_rustc;
mod lines;
mod listed_mistakes;
