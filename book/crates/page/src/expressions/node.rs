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
    /// A variable of the place, by its index.
    Variable(usize),
    /// A value that a `let` has written, by its index.
    Local(usize),
    /// A function of up to three values; the range is that of its name in the text.
    Call(&'static Function, Vec<Node>, Range<usize>),
    /// A condition and two branches.
    If(Vec<Node>),
    /// Writes a local.
    Let(usize, Box<Node>),
    /// Evaluates all, and has the value of the last.
    Block(Vec<Node>),
    Array(Vec<Node>),
    /// An element of an array, and its index.
    Index(Vec<Node>, Range<usize>),
}

/// A compiled part of a text, its type, and where it stands.
pub struct Part {
    pub node: Node,
    pub kind: Type,
    pub range: Range<usize>,
}

/// Range of a text at which the reader's program would stop, and the reason.
pub type Stop = (Range<usize>, &'static str);

impl Node {
    /// Computes its value for these values of the variables and the locals.
    pub fn evaluate(&self, variables: &[Value], locals: &mut [Value]) -> Result<Value, Stop> {
        let mut value_of = |node: &Self| node.evaluate(variables, locals);
        Ok(match self {
            Self::Constant(value) => value.clone(),
            Self::Variable(index) => variables[*index].clone(),
            Self::Local(index) => locals[*index].clone(),
            Self::Call(function, arguments, range) => {
                let value = match &arguments[..] {
                    [a] => (function.apply)(&[value_of(a)?]),
                    [a, b] => (function.apply)(&[value_of(a)?, value_of(b)?]),
                    [a, b, c] => (function.apply)(&[value_of(a)?, value_of(b)?, value_of(c)?]),
                    _ => (function.apply)(&[]),
                };
                match value {
                    Value::Stop(sentence) => return Err((range.clone(), sentence)),
                    value => value,
                }
            }
            Self::If(parts) => {
                let is_true = matches!(value_of(&parts[0])?, Value::Bool(true));
                value_of(&parts[if is_true { 1 } else { 2 }])?
            }
            Self::Let(index, node) => {
                locals[*index] = node.evaluate(variables, locals)?;
                Value::Bool(false)
            }
            Self::Block(nodes) => {
                let mut value = Value::Bool(false);
                for node in nodes {
                    value = value_of(node)?;
                }
                value
            }
            Self::Array(nodes) => {
                let values = nodes.iter().map(value_of);
                Value::Array(values.collect::<Result<Vec<_>, _>>()?.into())
            }
            Self::Index(parts, range) => match (value_of(&parts[0])?, value_of(&parts[1])?) {
                (Value::Array(all), Value::Usize(index)) if index < all.len() as u64 => {
                    all[index as usize].clone()
                }
                _ => return Err((range.clone(), "It has no such element; the first is [0].")),
            },
        })
    }

    /// Whether all that it is made of is a constant.
    pub fn is_constant(&self) -> bool {
        let is_constant = |node: &Self| matches!(node, Self::Constant(_));
        match self {
            Self::Call(_, nodes, _)
            | Self::If(nodes)
            | Self::Block(nodes)
            | Self::Array(nodes)
            | Self::Index(nodes, _) => nodes.iter().all(is_constant),
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
