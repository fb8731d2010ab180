//! Places as they stand draw the locked pictures, and what Rust would refuse is refused. That an
//! edited place draws what a listed mistake there draws is tested with them.

mod judged_by_rustc;
mod lines;
mod listed_mistakes;
