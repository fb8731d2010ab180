//! Builds the book from its chapters, the five crates and the locked pictures.
//!
//! `Sources` is everything that the chapters show: files in the workspace, and the pictures and
//! scripts in `generated/`. `ChapterPreprocessor` is the mdBook preprocessor that expands the
//! chapters, both for `mdbook serve` and for `cargo run`. `build` has mdBook write the pages,
//! copies the stylesheets into them, and writes the search index. Finally it checks every link, and
//! that the tags on every page are nested as HTML requires.
//!
//! A chapter is Markdown with *directives*, `{{#kind words}}`. Most directives stand in a paragraph
//! of their own; `value`, `number` and `our-folder` are part of a sentence:
//!
//! - A *listing* is a code fence with a single `include` of a file or part of a file. It marks the
//!   places that a reader may edit (`course::Place`). In a fence `rust,own_scene`, the page updates
//!   the listing when the reader changes that scene.
//! - A *console* is a code fence with commands: `console,ours` for commands to be run in our folder
//!   (the workspace of this book), `console,yours` for the reader's own folder, and
//!   `console,yours,refused` or `console,yours,fails` if the command is meant to be refused or to
//!   fail, which a test verifies.
//! - A *value* is computed by the steps when the book is built. A *number* is updated on the page
//!   when its interactive figure changes.
//! - A *figure* is a drawing from the crate `figures`, and a *picture* is a PNG file, either a
//!   locked picture or one generated from the code. Followed by `live`, a picture is interactive:
//!   its *controls* set its parameters. Followed by `preview`, it has no controls, and becomes
//!   interactive once the reader touches it.
//! - `pixel-panel` … `end` is the box *This pixel* below an interactive picture with a *probe*. Its
//!   text follows the chosen pixel from its ray to its three bytes, with a `number` for each
//!   intermediate result. In a table inside that box, `rows` becomes a row for each sphere or
//!   mirror. Its words are a picture's name and the columns to show.
//! - A *box* (`predict`, `hints`, `aside`, `answer` … `end`) is folded until the reader opens it.
//! - A `problem` is solved on paper. Its answer is a number, and the box `answer` shows how to get
//!   there. `problem-sheet` repeats the problems from all chapters.
//! - `mistakes` is a gallery of the mistakes in a step, each with its picture.
//! - `check` is a form that says whether a reader's picture is right.
//! - A `note` is a remark of one paragraph, such as some history, an opinion, or a letter with two
//!   meanings. Bold words at its beginning are its label. `rust` explains some Rust that a beginner
//!   won't know yet, and `by-hand` names the test that verifies the numbers worked out by hand
//!   above it. A note comes after the block that it belongs to, and stands beside it in the margin
//!   if there is room.
//! - `our-folder` says where the book's source is.
//!
//! A *fault* is an error on a line of a chapter, for the author to fix. The build reports all
//! faults, and stops.

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
mod open_box;
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
pub use console::ConsoleKind;
pub use files::Files;
pub use page::{Element, Page, Site};
pub use preprocessor::ChapterPreprocessor;
pub use sources::Sources;
