/// An expression: a number, the name of another line, or an operation.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Node {
    Number(f64),
    /// Another line, by its place in the tree; or a number of the scene.
    Name(usize),
    /// The unknown number, or vector, that is looked for.
    Free(Kind),
    /// The argument of a line that has one.
    Argument,
    Of(Op, Vec<Node>),
}

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Scalar,
    Vector,
    Truth,
}

/// An operation; its operands are in the order in which they are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Pow,
    Max,
    Min,
    Dot,
    Cross,
    Neg,
    Sqrt,
    Abs,
    Length,
    Unit,
    Tan,
    Atan,
    Sin,
    Cos,
    Acos,
    Floor,
    Ceil,
    Less,
    LessOrEqual,
    If,
    Vector,
    /// x, y or z (0 to 2) of a vector.
    Part(usize),
    /// A line of one argument, of this.
    Call(usize),
    /// Which object is the nearest: that of a number less than the least one so far and
    /// a margin; −1 if none is met.
    Nearest,
    /// A number of the nearest object.
    Chosen,
    /// The sum over all lights, their product, the largest of them, or one of them alone.
    Sum,
    Product,
    Most,
    Alone(usize),
    /// The mean over all rays of a pixel, or the last of them alone.
    Mean,
    Last,
}

impl Node {
    pub fn of(op: Op, nodes: impl Into<Vec<Self>>) -> Self {
        Self::Of(op, nodes.into())
    }

    /// Whether a name stands in it.
    pub fn has(&self, name: usize) -> bool {
        self.any(&|node| *node == Self::Name(name))
    }

    /// Whether it is true of any part of it.
    pub fn any(&self, is: &dyn Fn(&Self) -> bool) -> bool {
        let below = match self {
            Self::Of(_, nodes) => nodes.iter().any(|node| node.any(is)),
            _ => false,
        };
        below || is(self)
    }

    /// With each part replaced that `change` replaces.
    pub fn map(&self, change: &dyn Fn(&Self) -> Option<Self>) -> Self {
        match (change(self), self) {
            (Some(other), _) => other,
            (None, Self::Of(op, nodes)) => {
                Self::Of(*op, nodes.iter().map(|node| node.map(change)).collect())
            }
            _ => self.clone(),
        }
    }

    /// Its kind, or None where it makes no sense; `kind` knows those of the names.
    pub fn kind(&self, kind: &dyn Fn(usize) -> Kind) -> Option<Kind> {
        use Kind::{Scalar, Truth, Vector};
        let Self::Of(op, nodes) = self else {
            return Some(match self {
                Self::Name(name) => kind(*name),
                Self::Free(kind) => *kind,
                _ => Scalar,
            });
        };
        let kinds: Option<Vec<_>> = nodes.iter().map(|n| n.kind(kind)).collect();
        match (op, &kinds?[..]) {
            (Op::Pow, [a, Scalar]) => Some(*a),
            (Op::Add | Op::Sub | Op::Mul | Op::Div, [a, b])
            | (Op::Max | Op::Min, [a, b])
                if *a != Truth && *b != Truth =>
            {
                Some(if *a == Scalar { *b } else { *a })
            }
            (Op::Dot, [Vector, Vector]) => Some(Scalar),
            (Op::Cross, [Vector, Vector]) => Some(Vector),
            (Op::Length, [Vector]) => Some(Scalar),
            (Op::Unit, [Vector]) => Some(Vector),
            (Op::Less | Op::LessOrEqual, [Scalar, Scalar]) => Some(Truth),
            (Op::If, [Truth, a, b]) if *a != Truth && *b != Truth => {
                Some(if *a == Scalar { *b } else { *a })
            }
            (Op::Vector, [Scalar, Scalar, Scalar]) => Some(Vector),
            (Op::Part(_), [Vector]) => Some(Scalar),
            (Op::Neg | Op::Abs | Op::Floor | Op::Ceil | Op::Sqrt, [a])
                if *a != Truth =>
            {
                Some(*a)
            }
            (
                Op::Tan | Op::Atan | Op::Sin | Op::Cos | Op::Acos | Op::Call(_),
                [Scalar],
            ) => Some(Scalar),
            (Op::Nearest, [Scalar, Scalar]) => Some(Scalar),
            (
                Op::Chosen
                | Op::Sum
                | Op::Product
                | Op::Most
                | Op::Alone(_)
                | Op::Mean
                | Op::Last,
                [a],
            ) => Some(*a),
            _ => None,
        }
    }
}
