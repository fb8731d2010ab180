use crate::expressions::refusal::{Checked, refuse};
use crate::expressions::value::Value;
use course::Place;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicI64, Ordering::Relaxed};

/// All of a text.
pub const WHOLE: Range<usize> = 0..usize::MAX;

/// Sentence about a picture that takes more steps than it may.
pub const TOO_LONG: &str = "That takes longer than a page should.";

/// Computes a value from those of the variables, and of `let` behind them, unless the reader's
/// program would stop.
pub type Run = Arc<dyn Fn(&mut Vec<Value>) -> Checked<Value> + Send + Sync>;

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
        if spend(self.steps) < 0 {
            return refuse(WHOLE, TOO_LONG);
        }
        (self.run)(&mut variables)
    }
}

/// The steps that a picture may still take.
pub static REMAINING_STEPS: AtomicI64 = AtomicI64::new(0);

/// Counts steps of a picture; gives those that remain.
pub fn spend(steps: i64) -> i64 {
    REMAINING_STEPS.fetch_sub(steps, Relaxed) - steps
}
