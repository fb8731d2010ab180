//! What the pages of the book call, compiled for the browser: what answers there, `check`,
//! and the pictures that it compares with. Each is a module of its own, as few readers of
//! a page drop a picture into it.

#[cfg(any(feature = "check", feature = "pictures"))]
mod pictures;
#[cfg(any(feature = "check", feature = "pictures"))]
pub use pictures::NAMES;
#[cfg(feature = "pictures")]
pub use pictures::draw;

#[cfg(feature = "check")]
mod check;
#[cfg(feature = "check")]
pub use check::{check, keep};

mod answer;
pub use answer::answer;

// A name that is kept for the page counts as unsafe, as it could clash with another.
#[allow(unsafe_code)]
mod page;
