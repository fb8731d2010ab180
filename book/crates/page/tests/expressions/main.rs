//! Edited lines draw what the reader's own program would, and what Rust would refuse is refused.

mod judged_by_rustc;
mod lines;
mod listed_mistakes;
