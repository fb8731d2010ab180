//! The compiled parts of a line.

use crate::expressions::evaluation::Run;
use crate::expressions::operation::range_of;
use crate::expressions::refusal::{Fault, Refusal, refuse};
use crate::expressions::value::Value;
use course::ValueType;
use std::ops::Range;
use syn::Lit;

/// A compiled part of a line.
#[derive(Clone)]
pub struct Part {
    pub run: Run,
    pub value_type: ValueType,
    /// Whether the part is a literal such as 2.0, or made of such literals alone, so that Rust
    /// doesn't know its type yet. Such a part has no methods.
    pub is_open: bool,
    /// The bytes of the line that the part was compiled from.
    pub range: Range<usize>,
}

impl Part {
    /// A part that has this value for every pixel.
    pub fn constant(value: Value, is_open: bool, range: Range<usize>) -> Self {
        Self { run: Run::Constant(value), value_type: value.value_type(), is_open, range }
    }

    /// The part's value, if it is the same for every pixel.
    pub fn constant_value(&self) -> Option<Value> {
        if let Run::Constant(value) = self.run { Some(value) } else { None }
    }
}

/// Compiles a number, `true` or `false`.
pub fn literal_part(literal: &Lit) -> Result<Part, Refusal> {
    let value = match literal {
        Lit::Bool(truth) => Some(Value::Bool(truth.value)),
        Lit::Int(number) => number.base10_parse().map(Value::I32).ok(),
        Lit::Float(number) => number.base10_parse().map(Value::F64).ok(),
        _ => None,
    };
    let suffix = literal.suffix();
    let range = range_of(literal);
    match value {
        Some(Value::F64(f64::INFINITY)) => refuse(range, Fault::BeyondF64),
        Some(value) if suffix.is_empty() || suffix == value.value_type().name() => {
            Ok(Part::constant(value, suffix.is_empty(), range))
        }
        _ => refuse(range, Fault::Literal),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of a literal, and whether its type is still open.
    fn parse(text: &str) -> Result<(Value, bool), Fault> {
        let literal = syn::parse_str(text).expect("a literal");
        let part = literal_part(&literal).map_err(|refusal| refusal.fault)?;
        Ok((part.constant_value().expect("a constant"), part.is_open))
    }

    #[test]
    fn literal_has_its_value_and_its_type() {
        assert_eq!(parse("2"), Ok((Value::I32(2), true)));
        assert_eq!(parse("2_i32"), Ok((Value::I32(2), false)));
        assert_eq!(parse("2.5"), Ok((Value::F64(2.5), true)));
        assert_eq!(parse("1e-3f64"), Ok((Value::F64(0.001), false)));
        assert_eq!(parse("1e999"), Err(Fault::BeyondF64));
        for text in ["2_u8", "2.0_f32", "2147483648", "'a'"] {
            assert_eq!(parse(text), Err(Fault::Literal), "{text}");
        }
    }
}
