//! Builds the book from its chapters, the five crates and the locked pictures.
//!
//! `Sources` is everything that the chapters show: files of the workspace, and the pictures and
//! scripts in `generated/`. `ChapterPreprocessor` is the mdBook preprocessor that expands the chapters, both for
//! `mdbook serve` and for `cargo run`. `build` lets mdBook write the pages, copies the stylesheets
//! into them and writes the search index. Finally it checks every link, and that the elements of every
//! page are nested as HTML asks.
//!
//! A chapter is Markdown with *directives*, `{{#kind words}}`. Most are a paragraph of their own;
//! `value`, `number` and `our-folder` are part of a sentence:
//!
//! - A *listing* is a fence with one `include` of a file, or a part of a file. It marks the places
//!   that a reader may edit (`course::Place`). In a fence `rust,own_scene`, it is updated on the
//!   page when that picture changes.
//! - A *console* is a fence of commands: `console,ours` for our folder, `console,yours` for the
//!   reader's, and `console,yours,refused` or `console,yours,fails` if a test expects that.
//! - An `algorithm` is a fence of lines in words. What has two blanks or more before it at the end
//!   of a line is the name of a step.
//! - A *value* is computed by the steps when the book is built. A *number* is updated on the page
//!   when its interactive figure changes.
//! - A *figure* is a drawing of the crate `figures`, and a *picture* is a PNG file, locked or made
//!   from code. Followed by `live`, a picture is interactive: its *controls* set the parameters.
//! - `pixel-panel` … `end` is the box *This pixel* below an interactive picture with a *probe*. Its
//!   text has a `number` for each step from the ray of the chosen pixel to its three bytes. In a
//!   table there, `rows` with a picture and columns becomes a row for each sphere or mirror.
//! - A *box* (`predict`, `hints`, `aside`, `answer` … `end`) is folded until the reader opens it.
//! - A `problem` is solved on paper. Its answer is a number, and the box `answer` shows how to get
//!   there. `problem-sheet` repeats the problems of all chapters.
//! - `mistakes` is a gallery of the mistakes of a step, each with its picture.
//! - `check` is the form that says whether a picture is right.
//! - A `note` is one paragraph about something beside the line of the chapter, such as history, an
//!   opinion, or a letter that is used twice. Bold words at its beginning are its label. `rust` is a
//!   note on Rust that a beginner won't know yet, and `by-hand` names the test of the numbers that
//!   were worked out above it. Notes follow the block that they stand beside, and go into the margin
//!   if there is room for one.
//! - `our-folder` says where the source of the book is.
//!
//! A *fault* is an error on a line of a chapter, for its author to mend. The build reports all
//! faults and stops.

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

mod algorithm;
mod check_form;
mod console;
mod controls;
mod figure;
mod folded_box;
mod listing;
mod mistake_gallery;
mod note;
mod picture;
mod pixel_panel;
mod problem;

mod chapter;

mod preprocessor;

mod inline_stylesheets;
mod links;
mod nesting;
mod search;

mod build;

#[cfg(test)]
mod tests;

pub use build::build;
pub use files::Files;
pub use page::{Element, Page, Site};
pub use preprocessor::ChapterPreprocessor;
pub use sources::Sources;
