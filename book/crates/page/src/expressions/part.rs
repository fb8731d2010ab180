//! The compiled parts of a line.

use crate::expressions::evaluation::Computation;
use crate::expressions::operation::range_of;
use crate::expressions::refusal::{Fault, Refusal, refuse};
use crate::expressions::value::Value;
use course::ValueType;
use quote::ToTokens;
use std::ops::Range;
use syn::Lit;

/// A compiled part of a line.
pub struct Part {
    pub code: Code,
    /// The part's byte range in the line.
    pub range: Range<usize>,
}

/// The code to which a part of a line is compiled.
#[derive(Clone)]
pub struct Code {
    pub computation: Computation,
    pub value_type: ValueType,
    /// Whether the value comes only from unsuffixed literals such as `2.0`. Rust hasn't inferred
    /// the type of such a value yet, so no method can be called on the value.
    pub has_ambiguous_type: bool,
}

impl Code {
    /// Returns code that has this value for every pixel.
    pub fn constant(value: Value, has_ambiguous_type: bool) -> Self {
        Self {
            computation: Computation::Constant(value),
            value_type: value.value_type(),
            has_ambiguous_type,
        }
    }

    /// Returns the value of this code, if the value is the same for every pixel.
    pub fn constant_value(&self) -> Option<Value> {
        if let Computation::Constant(value) = self.computation { Some(value) } else { None }
    }
}

/// Compiles a number, `true` or `false`.
pub fn compile_literal(literal: &Lit) -> Result<Code, Refusal> {
    let range = range_of(literal);
    let (digits, suffix) = match literal {
        Lit::Bool(truth) => return Ok(Code::constant(Value::Bool(truth.value), false)),
        Lit::Int(number) => (number.base10_digits(), number.suffix()),
        Lit::Float(number) => (number.base10_digits(), number.suffix()),
        _ => return refuse(range, Fault::Literal),
    };
    let is_whole = matches!(literal, Lit::Int(_));
    // Rust doesn't allow 0b1_f64, and reads 0x1_f64 as a whole number.
    let is_decimal =
        !["0b", "0o", "0x"].iter().any(|start| write_literal(literal).starts_with(start));
    let value = match (suffix, is_whole) {
        ("" | "i32", true) => digits.parse().map(Value::I32).ok(),
        ("", false) | ("f64", _) if is_decimal => digits.parse().map(Value::F64).ok(),
        _ => None,
    };
    match value {
        Some(Value::F64(f64::INFINITY)) => refuse(range, Fault::BeyondF64),
        Some(value) => Ok(Code::constant(value, suffix.is_empty())),
        None => refuse(
            range,
            match suffix {
                "" | "i32" if is_whole => Fault::BeyondI32 { cure: format!("{digits}.0") },
                "f16" | "f32" | "f128" => Fault::Suffix { cure: format!("{digits}_f64") },
                "i8" | "i16" | "i64" | "i128" | "isize" | "u8" | "u16" | "u32" | "u64" | "u128"
                | "usize"
                    if is_whole =>
                {
                    Fault::Suffix { cure: format!("{digits}_i32") }
                }
                _ => Fault::Literal,
            },
        ),
    }
}

/// Writes a literal as it appears in the line, with any prefix and suffix, as in `0x1_f64`.
fn write_literal(literal: &Lit) -> String {
    literal.to_token_stream().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the value of a literal, and whether its type is still ambiguous.
    fn value_of_literal(text: &str) -> Result<(Value, bool), Fault> {
        let literal = syn::parse_str(text).expect("a literal");
        let code = compile_literal(&literal).map_err(|refusal| refusal.fault)?;
        Ok((code.constant_value().expect("a constant"), code.has_ambiguous_type))
    }

    #[test]
    fn literal_has_its_value_and_its_type() {
        assert_eq!(value_of_literal("2"), Ok((Value::I32(2), true)));
        assert_eq!(value_of_literal("2_i32"), Ok((Value::I32(2), false)));
        assert_eq!(value_of_literal("2.5"), Ok((Value::F64(2.5), true)));
        assert_eq!(value_of_literal("1e-3f64"), Ok((Value::F64(0.001), false)));
        assert_eq!(value_of_literal("1e999"), Err(Fault::BeyondF64));
        for text in ["60f64", "60_f64", "6_0f64", "60.0_f64", "6e1_f64"] {
            assert_eq!(value_of_literal(text), Ok((Value::F64(60.0), false)), "{text}");
        }
        let cure = |text| value_of_literal(text).expect_err("a fault").cure().map(str::to_owned);
        assert_eq!(cure("2_u8").as_deref(), Some("2_i32"));
        assert_eq!(cure("2.5_f32").as_deref(), Some("2.5_f64"));
        assert_eq!(cure("1f32").as_deref(), Some("1_f64"));
        assert_eq!(cure("2147483648").as_deref(), Some("2147483648.0"));
        for text in ["2a", "0b1f64", "2.0_i32", "'a'"] {
            assert_eq!(value_of_literal(text), Err(Fault::Literal), "{text}");
        }
    }
}
