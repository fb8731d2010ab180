//! Compiled lines, and how they are evaluated.

use crate::expressions::value::Value;
use course::Step;
use std::ops::Range;
use std::rc::Rc;

/// A compiled line: a function of the variables at its place.
#[derive(Clone)]
pub struct CompiledLine {
    /// The index of the line's place in places.txt.
    pub(super) place_index: usize,
    pub(super) place_name: &'static str,
    pub(super) step: Step,
    /// The length of the line, in bytes.
    pub(super) length: usize,
    pub(super) computation: Computation,
}

impl CompiledLine {
    /// Computes the line's value from the values of its variables. Returns None if the reader's
    /// program would panic.
    pub fn evaluate(&self, variables: &[Value]) -> Option<Value> {
        Evaluation::new(u64::MAX).evaluate(&self.computation, variables).ok()
    }
}

/// How to compute the value of a part of a line, such as an operand.
#[derive(Clone)]
pub enum Computation {
    /// The value is the same for every pixel.
    Constant(Value),
    /// The value is read from this slot.
    Slot(usize),
    /// The closure computes the value.
    Closure(Rc<ValueClosure>),
}

/// A closure that computes the value of a part of a line.
pub type ValueClosure = dyn Fn(&mut Evaluation) -> Result<Value, Interruption>;

impl Computation {
    #[inline]
    pub fn evaluate(&self, evaluation: &mut Evaluation) -> Result<Value, Interruption> {
        match self {
            Computation::Constant(value) => Ok(*value),
            Computation::Slot(slot) => Ok(evaluation.slots[*slot]),
            Computation::Closure(closure) => closure(evaluation),
        }
    }
}

/// Why a line couldn't be evaluated.
#[derive(Clone, Debug)]
pub enum Interruption {
    /// The reader's program would panic at this range of the line.
    NoResult(Range<usize>),
    /// The picture has used up its operations.
    OutOfOperations,
}

/// The state in which lines are evaluated.
pub struct Evaluation {
    /// The values of the place's variables, followed by the values that `let` binds.
    pub slots: Vec<Value>,
    /// The number of operations that the picture may still take.
    operations_left: u64,
}

impl Evaluation {
    /// Creates a state with this many operations to spend.
    pub const fn new(operations: u64) -> Self {
        Self { slots: vec![], operations_left: operations }
    }

    /// Computes a line's value from the values of its variables.
    pub fn evaluate(
        &mut self,
        computation: &Computation,
        variables: &[Value],
    ) -> Result<Value, Interruption> {
        self.spend(1)?;
        self.slots.clear();
        self.slots.extend_from_slice(variables);
        computation.evaluate(self)
    }

    /// Subtracts `operations` from the number of operations that the picture may still take. Each
    /// evaluation of a function, a method, an operator or a branch costs one operation, since all
    /// of these take about equally long. The exception is a remainder, which can cost more than
    /// one. In addition, each evaluation of a line costs one operation. We count operations instead
    /// of measuring time, so that every machine refuses the same lines.
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
            let value = evaluation.evaluate(&Computation::Slot(0), &[Value::F64(number)]);
            assert_eq!(value.ok(), Some(Value::F64(number)));
        }
        assert!(evaluation.evaluate(&Computation::Slot(0), &[Value::F64(3.0)]).is_err());
    }
}
