//! What readers are told about a line that can't be drawn.

use crate::expressions::value::{capitalise, describe_type};
use course::ValueType;
use std::ops::Range;
use thiserror::Error;

/// The error for a line that can't be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{fault}")]
pub struct Refusal {
    /// The byte range at fault in the line.
    pub range: Range<usize>,
    /// What is wrong with this range.
    pub fault: Fault,
}

/// Refuses a range of the line.
pub fn refuse<T>(range: Range<usize>, fault: Fault) -> Result<T, Refusal> {
    Err(Refusal { range, fault })
}

/// What is wrong with a part of a line, told to the reader in one or two sentences. A list of names
/// may follow, after a line break.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs, reason = "each variant's error message documents it")]
pub enum Fault {
    // Faults in the text.
    #[error("That's longer than a line should be.")]
    LongText,
    #[error("This is a control character, which is invisible.")]
    ControlCharacter,
    #[error(
        "A page can't read {0}. Rust has a * b, a.dot(b), a / b, a - b, .powi(2), .sqrt(), \
         <=, std::f64::consts::PI."
    )]
    UnreadableCharacter(char),
    #[error("This comment would hide what follows in the listing's row: write /* … */.")]
    LineComment,
    #[error("Rust reads <- as one sign: put a space after the <.")]
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
    #[error("Here, let needs a block around it: {{ let x = 1.0; 2.0 * x }}.")]
    Statement,
    #[error("Leave out the ; here: what ends in a ; is a statement, and has no value.")]
    Semicolon,
    #[error("The line has to be one value: leave out the ;, and what comes before or after it.")]
    TwoStatements,
    #[error("A value is missing after this.")]
    MissingAfter,
    #[error("Something is missing before this, such as a value, * or +.")]
    MissingBefore,
    #[error("A value is missing before this. For a power, write .powi(2).")]
    Dereference,
    #[error("Leave out the &.")]
    Reference,
    #[error("For =, Rust has == to compare.")]
    Comparison,
    #[error("This gives {left} a new value, but the line itself has to be a value. Write {cure}.")]
    Assignment { left: String, cure: String },
    #[error("{0} changes a value, but the line itself has to be a value. Leave out the =.")]
    CompoundAssignment(String),
    #[error("A page can't change a value. Give the new one a name of its own, with let.")]
    Reassignment,
    #[error("This if needs an else {{ … }}: what is the value otherwise?")]
    MissingElse,
    #[error("In a block, a page knows let x = …; and a value at the end, nothing else.")]
    Block,
    #[error("This block needs a value at its end, without a ; after it.")]
    BlockWithoutValue,
    #[error("A page knows no other types than f64, DVec3, i32, bool and [f64; 3].")]
    TypeName,
    #[error("Use a different name here, in lower-case letters.")]
    Name,
    #[error("{0} is already taken, and a page can't give a name twice. Use a different one.")]
    TakenName(String),
    #[error("Put parentheses around the block at the beginning.")]
    BlockAtStart,
    #[error("This comes after a &&: put parentheses around it.")]
    OrAfterAnd,
    #[error(
        "A page can't draw with this part of Rust: it knows let, if … else, blocks, arrays of \
         three numbers, vectors and their methods."
    )]
    Unsupported,
    #[error("A page can't draw with match. Write if … {{ … }} else {{ … }}.")]
    Match,

    // Faults in the types.
    #[error("That's beyond an f64.")]
    BeyondF64,
    #[error("Rust can't read this as a number. Is a * missing?")]
    Literal,
    #[error("That's beyond an i32. Write {cure}.")]
    BeyondI32 { cure: String },
    #[error("The numbers here are f64 and i32. Write {cure}.")]
    Suffix { cure: String },
    #[error("Rust can't tell yet which kind of number this is: write _f64 after it.")]
    UntypedValue,
    #[error("Rust can't tell yet which kind of number this is: write {cure}.")]
    UntypedLiteral { cure: String },
    #[error("Rust can't tell yet which kind of number this is: write 2.0_f64 for 2.0.")]
    UntypedReceiver,
    #[error("Write {cure}: Rust doesn't mix whole numbers with others.")]
    WholeNumber { cure: String },
    #[error("{subject} {}, not {}.{cure}", describe_type(*.wanted), describe_type(*.actual))]
    Mismatch { subject: String, wanted: ValueType, actual: ValueType, cure: &'static str },

    // Faults in the names.
    #[error("This file has no use glam::DVec3.")]
    NoVectors,
    #[error("For powers, Rust has .powi(2) or .powf(0.5).")]
    Caret,
    #[error("Between these brackets, write 0, 1 or 2.")]
    Index,
    #[error("An array here has three numbers.")]
    ArrayLength,
    #[error("After as, write f64 or i32.")]
    Cast,
    #[error("A page can't draw with {0}.")]
    Operator(String),
    #[error("{name} takes {wanted}, and here {actual}.")]
    Count { name: String, wanted: String, actual: String },
    #[error("It's a value, not a function: write {cure}.")]
    NoFunction { cure: String },
    #[error("In Rust, it's a method: {cure}.")]
    Method { cure: String },
    #[error("In Rust, write {cure}.")]
    Function { cure: String },
    #[error("It's a field, not a method: write {cure}.")]
    Field { cure: String },
    #[error("It's a method, not a field: write {cure}.")]
    MissingParentheses { cure: String },
    #[error("A page can't read .into(). Write {cure}.")]
    Into { cure: String },
    #[error("{name} isn't known here, but {near_name} is.")]
    NearName { name: String, near_name: String },
    #[error(
        "{} has no {name}. {} has it.",
        capitalise(describe_type(*.receiver)),
        capitalise(describe_type(*.owner))
    )]
    OtherReceiver { name: String, owner: ValueType, receiver: ValueType },
    #[error("{name} isn't known here. {} has:\n{members}", capitalise(describe_type(*.receiver)))]
    UnknownMember { name: String, receiver: ValueType, members: String },
    #[error("{name} isn't known here. {cure}")]
    UnknownName { name: String, cure: String },
    #[error("{name} isn't a number or a vector by itself. {cure}")]
    PartOfName { name: String, cure: String },
    #[error("A page can't draw with {name}. {cure}")]
    UnknownCall { name: String, cure: String },

    // Faults while the program draws.
    #[error("Here your program would stop: there is no result, or none that fits its type.")]
    NoResult,
    #[error("Here your program would stop: {0}.")]
    Assertion(&'static str),
    #[error("That takes longer than a page should.")]
    OutOfOperations,
}

impl Fault {
    /// Returns the replacement that the fault's sentence suggests for the range at fault. Returns
    /// None if the sentence suggests no replacement, or only a replacement with gaps.
    pub fn cure(&self) -> Option<&str> {
        let cure = match self {
            Fault::Assignment { cure, .. }
            | Fault::BeyondI32 { cure }
            | Fault::Field { cure }
            | Fault::Function { cure }
            | Fault::Into { cure }
            | Fault::Method { cure }
            | Fault::MissingParentheses { cure }
            | Fault::NearName { near_name: cure, .. }
            | Fault::NoFunction { cure }
            | Fault::UntypedLiteral { cure }
            | Fault::Suffix { cure }
            | Fault::WholeNumber { cure } => cure,
            Fault::Reference | Fault::Semicolon => "",
            _ => return None,
        };
        // A … is a gap, which only the reader can fill in.
        (!cure.contains('…')).then_some(cure)
    }
}
