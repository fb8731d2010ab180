use crate::expressions::types::Type;
use crate::expressions::value::Value;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// A value, or a sentence about why the reader's program would stop there.
pub type Outcome = Result<Value, &'static str>;

type Apply = Box<dyn Fn(&[Value]) -> Outcome + Send + Sync>;

/// A row of the table of all that a line may call.
pub struct Function {
    pub name: &'static str,
    pub takes: Vec<Type>,
    pub gives: Type,
    pub apply: Apply,
}

const NO_ELEMENT: &str = "Here your program would stop: it has no such element; the first is [0].";

/// A part of a compiled line.
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
    /// An element of an array or a vector, and its index.
    Index(Box<[Node; 2]>, Range<usize>),
}

/// A compiled part of a text, its type, and where it stands.
pub struct Part {
    pub node: Node,
    pub kind: Type,
    pub range: Range<usize>,
}

/// Why the reader's program would stop, and where in the text.
pub type Stop = (Range<usize>, &'static str);

impl Node {
    /// Its value with these values in the slots.
    pub fn evaluate(&self, slots: &mut [Value]) -> Result<Value, Stop> {
        match self {
            Self::Constant(value) => Ok(value.clone()),
            Self::Variable(slot) => Ok(slots[*slot].clone()),
            Self::Call(function, arguments, range) => {
                let mut values = [const { Value::Bool(false) }; 3];
                for (value, argument) in values.iter_mut().zip(arguments) {
                    *value = argument.evaluate(slots)?;
                }
                (function.apply)(&values).map_err(|sentence| (range.clone(), sentence))
            }
            Self::If(parts) => {
                let is_true = matches!(parts[0].evaluate(slots)?, Value::Bool(true));
                parts[if is_true { 1 } else { 2 }].evaluate(slots)
            }
            Self::Let(slot, node) => {
                slots[*slot] = node.evaluate(slots)?;
                Ok(Value::default())
            }
            Self::Block(nodes) => {
                let mut value = Value::default();
                for node in nodes {
                    value = node.evaluate(slots)?;
                }
                Ok(value)
            }
            Self::Array(nodes) => {
                let values: Result<Vec<_>, _> =
                    nodes.iter().map(|node| node.evaluate(slots)).collect();
                Ok(Value::Array(values?.into()))
            }
            Self::Index(parts, range) => {
                let (value, index) = (parts[0].evaluate(slots)?, parts[1].evaluate(slots)?);
                element(&value, &index).ok_or((range.clone(), NO_ELEMENT))
            }
        }
    }

    /// Whether all that it is made of is a constant.
    pub fn is_constant(&self) -> bool {
        let is_constant = |node: &Self| matches!(node, Self::Constant(_));
        match self {
            Self::Constant(_) => true,
            Self::Call(_, nodes, _) | Self::Block(nodes) | Self::Array(nodes) => {
                nodes.iter().all(is_constant)
            }
            Self::If(parts) => parts.iter().all(is_constant),
            Self::Index(parts, _) => parts.iter().all(is_constant),
            Self::Variable(_) | Self::Let(..) => false,
        }
    }
}

fn element(value: &Value, index: &Value) -> Option<Value> {
    let Value::Usize(index) = index else { return None };
    let index = usize::try_from(*index).ok()?;
    match value {
        Value::Array(values) => values.get(index).cloned(),
        Value::DVec3(vector) => vector.as_ref().get(index).copied().map(Value::F64),
        _ => None,
    }
}

/// The steps that a picture has taken so far.
static STEPS: AtomicU64 = AtomicU64::new(0);

/// Counts steps of a picture.
pub fn spend(steps: u64) {
    STEPS.fetch_add(steps, Relaxed);
}

/// Steps since the last call.
pub fn take_steps() -> u64 {
    STEPS.swap(0, Relaxed)
}

/// Steps since [`take_steps`].
pub fn spent_steps() -> u64 {
    STEPS.load(Relaxed)
}
