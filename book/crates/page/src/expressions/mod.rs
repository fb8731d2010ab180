//! The five steps, in which one expression may be the reader's: what the listings of the book
//! ask when a line is edited.
//!
//! A *place* is an expression of the steps that carries the lecture (`places.txt`). The build
//! script copies the steps' own source and puts a question, `editable!`, around each place;
//! all else of a picture is the steps' code. `parse` turns a reader's text into an
//! *expression*: a value of one *kind* (number, whole number, vector, truth) computed from the
//! *variables* of the place, by the *functions* of a table. What Rust would refuse is refused,
//! as a *mistake*: a range of the text and a sentence. `draw` draws the step of a place.

/// The reader's expression where `place` is edited, else the book's.
macro_rules! editable {
    ($place:literal, $book:expr, [$($variable:expr),*]) => {
        match $crate::expressions::drawing::is_edited($place) {
            false => $book,
            true => $crate::expressions::drawing::evaluate(&[$($crate::expressions::value::pack($variable)),*]),
        }
    };
}

#[allow(clippy::all, missing_docs, dead_code, unused_imports, reason = "copied code")]
mod steps {
    include!(concat!(env!("OUT_DIR"), "/steps.rs"));
}

mod functions;
mod parser;
mod refusal;
mod value;
pub use parser::{Expression, ParseError, parse_expression};

mod drawing;
pub use drawing::{draw_edited, editable_places, place_faults};
