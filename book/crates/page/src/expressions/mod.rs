//! Draws the five steps with the reader's expressions in them, as if the lines of the book's
//! listings had been edited.
//!
//! A *place* is an expression in the steps that matters in the lecture; `places.txt` lists them
//! all. The build script copies the steps' source, and makes each place first ask for the value of
//! the reader's line (`value_of_line`). The line is parsed by `syn`. The *compiler* looks up its
//! operators, functions and methods in a table of *functions*, with the same types as in Rust, and
//! combines what it finds into a single closure that runs for each pixel. Whatever Rust would
//! refuse is refused, with the range of the error and a sentence that explains it. The same
//! happens to a line that would make the reader's program panic while drawing, or that needs more
//! *operations* than a page has time for.

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

pub use compiler::parse_expression;
pub use edited_picture::{LineRefusal, draw_pixels, draw_some_pixels, draw_step_of_first_line};
pub use evaluation::Expression;
pub use refusal::{Fault, Refusal};
pub use value::Value;

// Called by the copied steps, like `draw_pixels`.
use edited_picture::{refuse_first_line_unless, value_of_line};
