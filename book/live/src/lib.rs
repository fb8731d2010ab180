//! What answers in the book: a figure is a function from its parameters to a
//! drawing, by the steps' own code.
//!
//! The builder prints what these functions give at their defaults. Nothing here knows
//! of the book, so that it compiles for a browser, too.

mod svg;
pub use svg::{Drawing, View, escape};

mod common;
pub use common::{camera, roots};

mod figures;
pub use figures::{Figure, figure, names};
