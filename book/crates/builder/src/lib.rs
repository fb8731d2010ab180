//! Builds the book from its chapters, the crates of the five steps, and the locked pictures.
//!
//! `Sources` gives access to everything that the chapters show: the files in the workspace, the
//! pictures and scripts in `generated/`, and the computed values. `ChapterPreprocessor` is the
//! mdBook preprocessor that expands the chapters, both for `mdbook serve` and for `cargo run`.
//! `build` calls mdBook to write the pages. Then it copies the stylesheets into the pages, and
//! writes the search index. Finally it checks every link, and checks that the tags on every page
//! are nested as HTML requires.
//!
//! A chapter is Markdown with *directives* of the form `{{#kind words}}`. Most directives need a
//! paragraph of their own, but `value`, `number` and `our-folder` may be part of a sentence. The
//! directives, and the code fences that the builder expands, are:
//!
//! - A *listing* is a code fence with a single `include` of a file or part of a file. In a listing,
//!   the places that a reader may edit (`course::Place`) are marked. A listing in a fence
//!   `rust,own_scene` belongs to the editable scene `own_scene`: when the reader changes the scene,
//!   the page updates the listing.
//! - A *console* is a code fence with commands. The commands in `console,ours` are for our folder
//!   (the workspace of this book). The commands in `console,yours` are for the reader's own folder.
//!   In `console,yours,refused`, the program is meant to refuse its arguments, and in
//!   `console,yours,fails`, a test is meant to fail. Our tests verify that the program or the test
//!   really fails.
//! - A *value* is computed by the code of the steps when the book is built. A *number* belongs to
//!   an interactive figure: the page updates the number when the reader changes that figure.
//! - A *figure* is a drawing from the crate `figures`. A *picture* is a PNG file in `generated/`. A
//!   picture that is followed by `live` is interactive, and the *controls* of the picture set its
//!   parameters. A picture that is followed by `preview` has no controls, and only becomes
//!   interactive when a reader points at the picture or focuses it.
//! - `pixel-panel` and `end` enclose the box *This pixel* below an interactive picture. The picture
//!   has a *probe*, the handle that selects a pixel. The text in the box follows the computation of
//!   the selected pixel from its ray to its three bytes, with a `number` for each intermediate
//!   result. In a table in the box, `rows` becomes one row for each sphere, or one row for each ray
//!   if there are mirrors. The words after `rows` are the picture's name and the columns.
//! - A *box* begins with `predict`, `hints`, `aside` or `answer`, and goes up to `end`. The box is
//!   folded until the reader opens it.
//! - A `problem` is for the reader to solve on paper. Its answer is a number, and its box `answer`
//!   shows how to find this number. `problem-sheet` repeats the problems from all chapters.
//! - `mistakes` becomes a gallery that shows how mistakes change the picture of a step.
//! - `check` becomes a form that says whether a reader's picture is right.
//! - A `note` is a remark of one paragraph, such as some history or an opinion. Bold words at its
//!   beginning are its label. `rust` is a note that explains some Rust that a beginner won't know
//!   yet. `by-hand` is a note that names a test. This test verifies the numbers that the text above
//!   works out by hand. In a chapter, a note follows the block that it belongs to. On the page, the
//!   note is in the margin beside that block. In a narrow window, the note follows the block.
//! - `our-folder` becomes words that say where the book's source is.
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
