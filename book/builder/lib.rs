//! Builds the book from its chapters, the five crates and the locked pictures.
//!
//! A chapter is Markdown. What it can hold beside that is in the modules of this
//! crate: a listing, a formula, a figure, a value, a picture and a box.

mod fault;
mod files;

mod formula;
mod markdown;
mod number;

mod boxes;
mod chain;
mod check;
mod excerpt;
mod figure;
mod knobs;
mod mistakes;
mod module;
mod picture;
mod pictures;
mod values;

mod draft;

mod element;
mod link;
mod page;
mod site;

mod browser;
mod course;
mod finish;
mod paper;
mod press;

#[cfg(test)]
mod tests;

pub use browser::open;
pub use course::{Course, answer};
pub use element::Element;
pub use fault::Fault;
pub use files::Files;
pub use link::faults;
pub use page::Page;
pub use press::build;
pub use site::Site;
