//! The five steps, in which some expressions may be the reader's: what the listings of the book
//! ask when lines are edited.
//!
//! A *place* is an expression of the steps that carries the lecture (`places.txt`). The build
//! script copies the steps' own source and puts a question, `editable!`, around each place.
//! `syn` reads a reader's text, and the *compiler* makes closures of it, which run for each pixel.
//! A value tells its type, and a table of *functions* what they do with values of which types: so
//! the compiler, which knows a *sample* of each part's value, finds out by calling a function
//! whether Rust would. What Rust would refuse is refused, with a range of the text and a sentence;
//! so is what would stop the reader's program while it draws.

/// The reader's expression where `place` is edited, else the book's.
macro_rules! editable {
    ($place:literal, $book:expr, [$($variable:expr),*]) => {
        match $crate::expressions::drawing::is_edited($place) {
            false => $book,
            true => {
                use $crate::expressions::{drawing::evaluate, value::Value};
                evaluate($place, vec![$(Value::from($variable)),*])
            }
        }
    };
}

/// Tells the page where a development build of the reader's program would stop.
macro_rules! debug_assert {
    ($condition:expr, $sentence:literal) => {
        if !$condition {
            $crate::expressions::drawing::stop_outside($sentence);
        }
    };
}

#[allow(clippy::all, missing_docs, dead_code, unused_imports, reason = "copied code")]
mod steps {
    include!(concat!(env!("OUT_DIR"), "/steps.rs"));
}

mod compiler;
mod drawing;
mod expression;
mod functions;
mod operation;
mod refusal;
mod refused_call;
mod statements;
mod syntax;
mod value;

pub use compiler::parse_expression;
pub use drawing::{TOO_LONG, draw_edited};
pub use refusal::Refusal;
pub use value::Value;
