use crate::expressions::types::Type;
use crate::expressions::value::Value;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

type Apply = Box<dyn Fn(&[Value]) -> Value + Send + Sync>;

/// A row of the table of all that a line may call.
pub struct Function {
    pub name: &'static str,
    pub takes: Vec<Type>,
    pub gives: Type,
    pub apply: Apply,
}

/// A compiled part of a line.
#[derive(Clone)]
pub enum Node {
    Constant(Value),
    /// The value in a slot: first those of the place's variables, then what `let` adds.
    Variable(usize),
    /// A function of up to three values; the range is that of its name in the text.
    Call(&'static Function, Vec<Node>, Range<usize>),
    /// A condition and two branches.
    If(Box<[Node; 3]>),
    /// Writes into a slot.
    Let(usize, Box<Node>),
    /// Evaluates all, and has the value of the last.
    Block(Vec<Node>),
    Array(Vec<Node>),
    /// An element of an array, and its index.
    Index(Box<[Node; 2]>, Range<usize>),
}

/// A compiled part of a text, its type, and where it stands.
pub struct Part {
    pub node: Node,
    pub kind: Type,
    pub range: Range<usize>,
}

/// Where in a text the reader's program would stop, and why.
pub type Stop = (Range<usize>, &'static str);

impl Node {
    /// Its value with these values in the slots.
    pub fn evaluate(&self, slots: &mut [Value]) -> Result<Value, Stop> {
        Ok(match self {
            Self::Constant(value) => value.clone(),
            Self::Variable(slot) => slots[*slot].clone(),
            Self::Call(function, arguments, range) => {
                let mut values = [const { Value::Bool(false) }; 3];
                for (value, argument) in values.iter_mut().zip(arguments) {
                    *value = argument.evaluate(slots)?;
                }
                match (function.apply)(&values) {
                    Value::Stop(sentence) => return Err((range.clone(), sentence)),
                    value => value,
                }
            }
            Self::If(parts) => {
                let is_true = matches!(parts[0].evaluate(slots)?, Value::Bool(true));
                parts[if is_true { 1 } else { 2 }].evaluate(slots)?
            }
            Self::Let(slot, node) => {
                slots[*slot] = node.evaluate(slots)?;
                Value::Bool(false)
            }
            Self::Block(nodes) => {
                let mut value = Value::Bool(false);
                for node in nodes {
                    value = node.evaluate(slots)?;
                }
                value
            }
            Self::Array(nodes) => {
                let values = nodes.iter().map(|node| node.evaluate(slots));
                Value::Array(values.collect::<Result<Vec<_>, _>>()?.into())
            }
            Self::Index(parts, range) => {
                match (parts[0].evaluate(slots)?, parts[1].evaluate(slots)?) {
                    (Value::Array(all), Value::Usize(index)) if index < all.len() as u64 => {
                        all[index as usize].clone()
                    }
                    _ => return Err((range.clone(), "It has no such element; the first is [0].")),
                }
            }
        })
    }

    /// Whether all that it is made of is a constant.
    pub fn is_constant(&self) -> bool {
        let is_constant = |node: &Self| matches!(node, Self::Constant(_));
        match self {
            Self::Call(_, nodes, _) | Self::Block(nodes) | Self::Array(nodes) => {
                nodes.iter().all(is_constant)
            }
            Self::If(parts) => parts.iter().all(is_constant),
            Self::Index(parts, _) => parts.iter().all(is_constant),
            node => is_constant(node),
        }
    }
}

/// The steps that a picture has taken so far.
pub static STEPS: AtomicU64 = AtomicU64::new(0);

/// Counts steps of a picture.
pub fn spend(steps: u64) {
    STEPS.fetch_add(steps, Relaxed);
}
