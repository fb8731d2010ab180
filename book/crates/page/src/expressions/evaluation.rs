//! A compiled line, and how it is evaluated.

use crate::expressions::value::Value;
use std::ops::Range;
use std::rc::Rc;

/// The meaning of a line: a function of the variables of its place.
#[derive(Clone)]
pub struct Expression {
    /// The position of its place in places.txt.
    pub(super) place_index: usize,
    pub(super) place_name: &'static str,
    pub(super) step_name: &'static str,
    /// The bytes of the line.
    pub(super) length: usize,
    pub(super) run: Run,
}

impl Expression {
    /// Computes the value of the line where its variables have these values. None if the reader's
    /// program would stop.
    pub fn evaluate(&self, variables: &[Value]) -> Option<Value> {
        Evaluation::new(u64::MAX).evaluate(&self.run, variables).ok()
    }
}

/// How to compute the value of a part of a line.
#[derive(Clone)]
pub enum Run {
    /// The value is the same at each pixel.
    Constant(Value),
    /// The value is in this slot.
    Slot(usize),
    /// The value is computed.
    Call(Rc<Call>),
}

/// Computes the value of an operation.
pub type Call = dyn Fn(&mut Evaluation) -> Result<Value, Interruption>;

impl Run {
    /// Computes the value.
    #[inline]
    pub fn evaluate(&self, evaluation: &mut Evaluation) -> Result<Value, Interruption> {
        match self {
            Run::Constant(value) => Ok(*value),
            Run::Slot(slot) => Ok(evaluation.slots[*slot]),
            Run::Call(call) => call(evaluation),
        }
    }
}

/// Why a picture isn't drawn to its end.
#[derive(Clone, Debug)]
pub enum Interruption {
    /// The reader's program would stop at this part of the line: there is no result.
    NoResult(Range<usize>),
    /// The operations that the picture may take are spent.
    OutOfOperations,
}

/// What lines need while they are evaluated.
pub struct Evaluation {
    /// The values of the place's variables, and behind them those of `let`.
    pub slots: Vec<Value>,
    /// The operations that the picture may still take.
    operations_left: u64,
}

impl Evaluation {
    /// Lets lines take this many operations.
    pub const fn new(operations: u64) -> Self {
        Self { slots: vec![], operations_left: operations }
    }

    /// Computes the value of a line from those of its variables.
    pub fn evaluate(&mut self, run: &Run, variables: &[Value]) -> Result<Value, Interruption> {
        self.spend(1)?;
        self.slots.clear();
        self.slots.extend_from_slice(variables);
        run.evaluate(self)
    }

    /// Counts operations. An operation is a function, a method, an operator or a branch that is
    /// evaluated once, or the evaluation of a line besides: none of them takes much longer than
    /// another. So a picture takes the same number of them on every machine.
    #[inline]
    pub fn spend(&mut self, operations: u64) -> Result<(), Interruption> {
        match self.operations_left.checked_sub(operations) {
            Some(operations_left) => self.operations_left = operations_left,
            None => return Err(Interruption::OutOfOperations),
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_are_spent_to_the_last() {
        let mut evaluation = Evaluation::new(3);
        assert!(evaluation.spend(2).is_ok() && evaluation.spend(1).is_ok());
        assert!(evaluation.spend(0).is_ok() && evaluation.spend(1).is_err());
    }

    #[test]
    fn each_evaluation_has_its_own_variables() {
        let mut evaluation = Evaluation::new(2);
        for number in [1.0, 2.0] {
            let value = evaluation.evaluate(&Run::Slot(0), &[Value::F64(number)]);
            assert_eq!(value.ok(), Some(Value::F64(number)));
        }
        assert!(evaluation.evaluate(&Run::Slot(0), &[Value::F64(3.0)]).is_err());
    }
}
