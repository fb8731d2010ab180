use crate::expressions::refusal::{Checked, refuse};
use crate::expressions::value::Value;
use course::Place;
use std::ops::Range;
use std::sync::atomic::{AtomicI64, Ordering::Relaxed};

/// A compiled part of a line.
#[derive(Clone)]
pub enum Node {
    Constant(Value),
    /// A variable of the place, or a value of `let`, by its index.
    Slot(usize),
    /// A function of up to three values; the range is that of its name in the text.
    Call(fn(&[Value]) -> Value, Vec<Node>, Range<usize>),
    /// A condition and two branches.
    If(Vec<Node>),
    /// What is written into a slot, and the value of the rest.
    Let(usize, Box<[Node; 2]>),
}

impl Node {
    /// Computes its value for these values of the slots, unless the reader's program would stop.
    pub fn evaluate(&self, slots: &mut [Value]) -> Checked<Value> {
        match self {
            Self::Constant(value) => Ok(*value),
            Self::Slot(index) => Ok(slots[*index]),
            Self::Call(apply, nodes, range) => {
                let mut values = [Value::Unfit; 3];
                for (value, node) in values.iter_mut().zip(nodes) {
                    *value = node.evaluate(slots)?;
                }
                match apply(&values[..nodes.len()]) {
                    Value::Stop(sentence) => refuse(range.clone(), sentence),
                    value => Ok(value),
                }
            }
            Self::If(nodes) => {
                let is_true = matches!(nodes[0].evaluate(slots)?, Value::Bool(true));
                nodes[if is_true { 1 } else { 2 }].evaluate(slots)
            }
            Self::Let(index, nodes) => {
                let [value, rest] = &**nodes;
                slots[*index] = value.evaluate(slots)?;
                rest.evaluate(slots)
            }
        }
    }

    /// Whether it is the same at each pixel.
    pub fn is_constant(&self) -> bool {
        match self {
            Self::Constant(_) => true,
            Self::Call(_, nodes, _) | Self::If(nodes) => nodes.iter().all(Self::is_constant),
            Self::Slot(_) | Self::Let(..) => false,
        }
    }
}

/// Meaning of a reader's text: a function of the variables of its place.
#[derive(Clone)]
pub struct Expression {
    pub(super) place: Place,
    pub(super) node: Node,
    /// How many variables and values of `let` it has.
    pub(super) slots: usize,
    /// Functions and operators that it calls at most.
    pub(super) steps: i64,
    /// Bytes of its text.
    pub(super) length: usize,
}

impl Expression {
    /// Computes its value for these values of the variables.
    pub fn evaluate(&self, mut variables: Vec<Value>) -> Checked<Value> {
        spend(self.steps);
        variables.resize(self.slots, Value::Unfit);
        self.node.evaluate(&mut variables)
    }
}

/// The steps that a picture may still take.
pub static REMAINING_STEPS: AtomicI64 = AtomicI64::new(0);

/// Counts steps of a picture.
pub fn spend(steps: i64) {
    REMAINING_STEPS.fetch_sub(steps, Relaxed);
}
