use crate::expressions::operation::range_of;
use crate::expressions::refusal::{Checked, refuse};
use crate::expressions::value::Value::{self, Bool, F64, I32};
use course::Place;
use std::ops::Range;
use std::sync::Arc;
use syn::Lit;

/// Computes a value from those of the variables, and of `let` behind them, unless the reader's
/// program would stop.
pub type Run = Arc<dyn Fn(&mut Vec<Value>) -> Checked<Value> + Send + Sync>;

/// A compiled part of a text.
#[derive(Clone)]
pub struct Part {
    pub run: Run,
    /// Whether it is the same at each pixel.
    pub is_constant: bool,
    /// A value of its type: its own, if it is constant.
    pub sample: Value,
    /// Whether it is a number such as 2.0, or a sum of such, which has no methods yet.
    pub is_open: bool,
    pub range: Range<usize>,
}

impl Part {
    /// A part with this value at each pixel.
    pub fn constant(sample: Value, is_open: bool) -> Self {
        Self { run: Arc::new(move |_| Ok(sample)), is_constant: true, sample, is_open, range: 0..0 }
    }
}

/// A number, or true or false.
pub fn literal_part(literal: &Lit) -> Checked<Part> {
    let sample = match literal {
        Lit::Bool(truth) => Some(Bool(truth.value)),
        Lit::Int(number) => number.base10_parse().map(I32).ok(),
        Lit::Float(number) => number.base10_parse().map(F64).ok(),
        _ => None,
    };
    let is_open = literal.suffix().is_empty();
    match (sample, literal.suffix()) {
        (Some(F64(f64::INFINITY)), _) => refuse(range_of(literal), "That's beyond an f64."),
        (Some(sample), "") | (Some(sample @ I32(_)), "i32") | (Some(sample @ F64(_)), "f64") => {
            Ok(Part::constant(sample, is_open))
        }
        _ => refuse(range_of(literal), "Rust has no such f64 or i32; or is a * missing?"),
    }
}

/// Meaning of a reader's text: a function of the variables of its place.
#[derive(Clone)]
pub struct Expression {
    pub(super) place: Place,
    pub(super) run: Run,
    /// Functions and operators that it calls at most.
    pub(super) steps: i64,
}

impl Expression {
    /// Computes its value for these values of the variables.
    pub fn evaluate(&self, mut variables: Vec<Value>) -> Checked<Value> {
        (self.run)(&mut variables)
    }
}
