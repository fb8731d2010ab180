//! Draws the five steps with the reader's expressions in them, as if the reader had edited the
//! steps' source.
//!
//! A *place* is an expression in the steps that a reader may edit. `places.txt` lists all places.
//! The build script copies the steps' source. In the copy, each place calls `value_of_line` for the
//! value of the reader's line. If the reader hasn't edited the place, the place evaluates the
//! book's code. `syn` parses the line. The *compiler* looks up the line's operators, functions and
//! methods in a table of *functions*. Each function in the table has the same types as in Rust. The
//! compiler combines the functions that the line uses into a single closure, which runs for each
//! pixel.
//!
//! A line is refused if Rust would refuse it, if it would make the reader's program panic while
//! drawing, or if it needs more *operations* than a page has time for. A refusal consists of the
//! range of the error and a sentence that explains the error.

#[allow(clippy::all, missing_docs, dead_code, unused, reason = "copied code")]
mod steps {
    include!(concat!(env!("OUT_DIR"), "/steps.rs"));
}

mod compiler;
mod edited_picture;
mod evaluation;
mod functions;
mod near_name;
mod operation;
mod part;
mod refusal;
mod refused_call;
mod statements;
mod syntax;
mod value;

pub use compiler::compile_line;
pub use edited_picture::{
    LineRefusal, draw_some_pixels, draw_spaced_pixels_until_refusal, draw_step_of_first_line,
};
pub use evaluation::CompiledLine;
pub use refusal::{Fault, Refusal};
pub use value::Value;

// The copied steps call these two functions, and also `draw_spaced_pixels_until_refusal`.
use edited_picture::{assert_or_refuse_first_line, value_of_line};
