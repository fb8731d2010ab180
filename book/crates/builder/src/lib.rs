//! Builds the book from its chapters, the five crates and the locked pictures.
//!
//! `Sources` are what the chapters show: the workspace, and the pictures and scripts that pages find
//! in `generated/`. `ChapterPreprocessor` expands the chapters, for `mdbook serve` as well as for
//! `cargo run`. `build` has mdBook write its pages, puts the styles into them, and writes the index of
//! the search. At the end, every link is followed.
//!
//! A chapter is Markdown with *directives*, `{{#kind words}}`. Most are a paragraph of their own;
//! `value`, `number` and `our-folder` are part of a sentence:
//!
//! - A *listing* is a fence with one `include` of a file of a step, or of a part of it. It says where
//!   a reader may edit it (`course::Place`). In a fence `rust,own_scene`, the page shows the program
//!   of that scene once the reader changes it.
//! - A *console* is a fence of commands: `console,ours` for our folder, `console,yours` for the
//!   reader's, and `console,yours,refused` or `console,yours,fails` if a test expects that.
//! - A *value* is computed by the steps when the book is built. A *number* is updated on the page
//!   when its interactive figure changes.
//! - A *figure* is a drawing of the crate `figures`, and a *picture* is a PNG file, locked or made
//!   from code. Followed by `live`, a picture is interactive: its *controls* set the parameters.
//! - `pixel-panel` … `end` is the box *This pixel* below an interactive picture with a *probe*. Its
//!   text has a `number` for each step from the ray of the chosen pixel to its three bytes. In its
//!   tables, `rows` with a picture and its columns is a row for each sphere or mirror.
//! - A *box* (`predict`, `hints`, `aside`, `answer` … `end`) is opened by its reader.
//! - A `problem` is to be solved on paper. It has a number for an answer, and the box `answer` holds
//!   the way to it. `problem-sheet` shows the problems of all chapters once more.
//! - `mistakes` are those of a step, with a picture each.
//! - `check` is the form that a picture is dropped into. `by-hand` names the test of what was worked
//!   out above it. `rust` is a margin note on Rust that a beginner won't know yet.
//! - `our-folder` says where the source of the book is.
//!
//! A *fault* is an error on a line of a chapter, which only its author can mend. The build reports
//! all faults and stops.

mod directive;
mod fault;
mod figure_file;
mod files;
mod page;
mod sources;

mod formula;
mod markdown;
mod numbers;
mod replace_between;
mod values;

mod check_form;
mod console;
mod controls;
mod figure;
mod folded_box;
mod listing;
mod mistake_gallery;
mod picture;
mod pixel_panel;
mod problem;

mod chapter;

mod preprocessor;

mod inline_stylesheets;
mod links;
mod search;

mod build;

#[cfg(test)]
mod tests;

pub use build::build;
pub use files::Files;
pub use page::{Element, Page, Site};
pub use preprocessor::ChapterPreprocessor;
pub use sources::Sources;
