//! Builds the book from its chapters, the five crates and the locked pictures.
//!
//! A chapter is Markdown. What it can hold beside that is in the modules of this
//! crate: a listing, a formula, a figure, a value, a picture and a box.

mod mistake;

mod page;
mod reader;

mod boxes;
mod caption;
mod figures;
mod formula;
mod gallery;
mod link;
mod listing;
mod picture;
mod svg;
mod values;
mod worked;

mod browser;
mod course;
mod press;
mod shading;

#[cfg(test)]
mod tests;

pub use browser::open;
pub use course::{Course, answer};
pub use press::{Built, build};
