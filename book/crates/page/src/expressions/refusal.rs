//! What readers are told about a line that can't be drawn.

use crate::expressions::value::describe_type;
use course::ValueType;
use std::ops::Range;
use thiserror::Error;

/// The error for a line that can't be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{fault}")]
pub struct Refusal {
    /// The range of bytes that is wrong.
    pub range: Range<usize>,
    /// What is wrong there.
    pub fault: Fault,
}

/// Refuses a range of the line.
pub fn refuse<T>(range: Range<usize>, fault: Fault) -> Result<T, Refusal> {
    Err(Refusal { range, fault })
}

/// What is wrong with a part of a line, told to the reader in one or two sentences. A list of names
/// may follow on its own line.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs, reason = "each has its sentence")]
pub enum Fault {
    // Faults in the text.
    #[error("That's longer than a line should be.")]
    LongText,
    #[error("A control character is here, which nobody sees.")]
    ControlCharacter,
    #[error(
        "A page can't read {0}. Rust has a * b, a.dot(b), a / b, a - b, .powi(2), .sqrt(), \
         <=, std::f64::consts::PI."
    )]
    UnreadableSign(char),
    #[error("This comment hides the rest of the line: write /* … */.")]
    LineComment,
    #[error("Rust reads <- as one sign: put a blank after the <.")]
    LeftArrow,
    #[error("For ? :, Rust has if … {{ … }} else {{ … }}.")]
    QuestionMark,

    // Faults in the syntax.
    #[error("Write a value here. Reset brings back the book’s.")]
    Nothing,
    #[error("The bracket that closes this one is missing.")]
    UnclosedBracket,
    #[error("This closes nothing.")]
    UnopenedBracket,
    #[error("Rust can't read on from here.")]
    Unreadable,
    #[error("Rust compares two at a time: a < b && b < c.")]
    ComparisonChain,
    #[error("Statements need a block: {{ let x = 1.0; 2.0 * x }}.")]
    Statement,
    #[error("A value is missing behind this.")]
    MissingBehind,
    #[error("Something is missing before this, such as a value, * or +.")]
    MissingBefore,
    #[error("A value is missing before this. Powers are .powi(2).")]
    Dereference,
    #[error("Leave out the &.")]
    Reference,
    #[error("For =, Rust has == to compare.")]
    Assignment,
    #[error("This if needs an else {{ … }}: what is the value otherwise?")]
    MissingElse,
    #[error("A block here has let x = …; and a value at its end.")]
    Block,
    #[error("Take another name here, in small letters.")]
    Name,
    #[error("Put parentheses around the block at the beginning.")]
    BlockAtStart,
    #[error("It stands behind a &&: put parentheses around it.")]
    OrAfterAnd,
    #[error(
        "A page can't draw with this part of Rust: it knows let, if … else, blocks, arrays of \
         three numbers, vectors and their methods."
    )]
    Unsupported,

    // Faults in the types.
    #[error("That's beyond an f64.")]
    BeyondF64,
    #[error("Rust has no such f64 or i32; or is a * missing?")]
    Literal,
    #[error("Rust can't tell yet which kind of number this is: write _f64 behind it.")]
    OpenValue,
    #[error("Rust can't tell yet which kind of number this is: write 2.0_f64 for 2.0.")]
    OpenReceiver,
    #[error("Write {cure}: Rust doesn't mix whole numbers with others.")]
    WholeNumber { cure: String },
    #[error("{subject} {}, not {}.{cure}", describe_type(*.wanted), describe_type(*.actual))]
    Mismatch { subject: String, wanted: ValueType, actual: ValueType, cure: &'static str },

    // Faults in the names.
    #[error("This file has no use glam::DVec3.")]
    NoVectors,
    #[error("For powers, Rust has .powi(2) or .powf(0.5).")]
    Caret,
    #[error("An array here has three numbers, [0], [1] and [2].")]
    Index,
    #[error("Behind as, there is f64 or i32.")]
    Cast,
    #[error("A page can't draw with {0}.")]
    Operator(String),
    #[error("{0} takes other values, or more or fewer.")]
    OtherValues(String),
    #[error("In Rust, it's a method: {0}.")]
    Method(String),
    #[error("{name} isn't known here. Of {}, there is:\n{members}", describe_type(*.receiver))]
    UnknownMember { name: String, receiver: ValueType, members: String },
    #[error("{name} isn't known here. {cure}")]
    UnknownName { name: String, cure: String },

    // Faults while the program draws.
    #[error("Here your program would stop: there is no result, or none that fits its type.")]
    NoResult,
    #[error("Here your program would stop: {0}.")]
    Assertion(&'static str),
    #[error("That takes longer than a page should.")]
    OutOfOperations,
}
