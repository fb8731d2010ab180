//! What the pages of the book call, compiled for the browser: what answers there, and
//! `check`. Each is a module of its own, as few readers of a page drop a picture into it.

#[cfg(feature = "check")]
mod pictures;
#[cfg(feature = "check")]
pub use pictures::{locked, names};

#[cfg(feature = "check")]
mod check;
#[cfg(feature = "check")]
pub use check::check;

mod answer;
pub use answer::answer;

// A name that is kept for the page counts as unsafe, as it could clash with another.
#[allow(unsafe_code)]
mod page;
