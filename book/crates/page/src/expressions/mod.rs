//! The five steps with expressions of the reader's in them: what the listings of the book draw when
//! their lines are edited.
//!
//! A *place* is an expression of the steps that carries the lecture; `places.txt` lists them all.
//! The build script copies the steps' own source and lets each place ask for the value of the
//! reader's line first (`value_of_line`). A line is read by `syn`. The *compiler* looks up its
//! operators, functions and methods in a table of *functions* with the types that Rust gives them,
//! and joins the functions that it finds into one that runs for each pixel. What Rust would refuse
//! is refused, with the part of the line that is wrong and a sentence. So is what would stop the
//! reader's program while it draws, and what needs more *operations* than a page has time for.

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
pub use edited_picture::{LineRefusal, draw_edited, draw_pixels, draw_some_pixels};
pub use evaluation::Expression;
pub use refusal::{Fault, Refusal};
pub use value::Value;

// What the copy of the steps calls, besides `draw_pixels`.
use edited_picture::{stop_unless, value_of_line};
