//! Splits an operation into its kind, its name and its operands. Operators, casts, fields, methods
//! and calls are all operations. The table of functions has entries for operations of every kind.

use crate::expressions::refusal::{Fault, Refusal, refuse};
use quote::ToTokens;
use std::iter::once;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::{Expr, UnOp};

/// The kinds of operations, which differ in how they are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OperationKind {
    /// A path, such as `DVec3::X`, alone or called with arguments.
    Path,
    /// A method of the first operand.
    Method,
    /// A field of the operand.
    Field,
    /// An operator in front of one operand or between two operands.
    Operator,
    /// A cast with `as`.
    Cast,
    /// An array, whose elements are the operands.
    Array,
    /// An element of an array or a vector.
    Index,
}

impl OperationKind {
    /// Whether the operation is a field or a method. If so, the first operand is the expression
    /// before the dot.
    pub fn is_member(self) -> bool {
        matches!(self, OperationKind::Method | OperationKind::Field)
    }
}

/// An operation in a line.
pub struct Operation<'a> {
    pub kind: OperationKind,
    /// What distinguishes the operation from others of its kind: the path, the name of the method
    /// or field, the sign, the type of the cast, or the index. For an array, the name is empty.
    pub name: String,
    pub operands: Vec<&'a Expr>,
    /// The range of the name in the line.
    pub name_range: Range<usize>,
}

/// Returns the byte range of this syntax within the line.
pub fn range_of(syntax: &impl Spanned) -> Range<usize> {
    syntax.span().byte_range()
}

/// Writes a part of the line without whitespace or comments.
pub fn write_without_spaces(syntax: &impl ToTokens) -> String {
    syntax.to_token_stream().to_string().split_whitespace().collect()
}

/// Splits an expression that is an operation, and refuses any other expression.
pub fn split_operation(syntax: &Expr) -> Result<Operation<'_>, Refusal> {
    let (kind, name, operands, name_range) = match syntax {
        Expr::Unary(unary) => {
            let name_range = range_of(&unary.op);
            if let UnOp::Deref(_) = unary.op {
                return refuse(name_range, Fault::Dereference);
            }
            let operands = vec![&*unary.expr];
            (OperationKind::Operator, write_without_spaces(&unary.op), operands, name_range)
        }
        Expr::Binary(binary) => {
            let operands = vec![&*binary.left, &*binary.right];
            let name = write_without_spaces(&binary.op);
            (OperationKind::Operator, name, operands, range_of(&binary.op))
        }
        Expr::Cast(cast) => {
            let name = write_without_spaces(&cast.ty);
            (OperationKind::Cast, name, vec![&*cast.expr], range_of(&cast.as_token))
        }
        Expr::Array(array) => {
            let operands = array.elems.iter().collect();
            (OperationKind::Array, String::new(), operands, range_of(array))
        }
        Expr::Index(index) => {
            let name = write_without_spaces(&index.index);
            let name_range = range_of(&index.bracket_token.span.join());
            (OperationKind::Index, name, vec![&*index.expr], name_range)
        }
        Expr::Field(field) => {
            let name = write_without_spaces(&field.member);
            let name_range = range_of(&field.dot_token).start..range_of(field).end;
            (OperationKind::Field, name, vec![&*field.base], name_range)
        }
        Expr::MethodCall(call) => {
            let name = format!("{}{}", call.method, write_without_spaces(&call.turbofish));
            let operands = once(&*call.receiver).chain(&call.args).collect();
            let name_range = range_of(&call.dot_token).start..range_of(&call.method).end;
            (OperationKind::Method, name, operands, name_range)
        }
        Expr::Path(path) => {
            (OperationKind::Path, write_without_spaces(path), vec![], range_of(path))
        }
        Expr::Call(call) if !call.args.is_empty() => {
            let operands = call.args.iter().collect();
            let name = write_without_spaces(&call.func);
            (OperationKind::Path, name, operands, range_of(&call.func))
        }
        Expr::Reference(reference) => {
            return refuse(range_of(&reference.and_token), Fault::Reference);
        }
        Expr::Match(branches) => return refuse(range_of(&branches.match_token), Fault::Match),
        _ => return refuse(range_of(syntax), Fault::Unsupported),
    };
    Ok(Operation { kind, name, operands, name_range })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_written_without_whitespace_or_comments() {
        for (text, tokens) in [
            ("ray . start", "ray.start"),
            ("f64 ::from( hit /* a hit */ )", "f64::from(hit)"),
            ("a -\n    b // c", "a-b"),
        ] {
            let syntax: Expr = syn::parse_str(text).expect(text);
            assert_eq!(write_without_spaces(&syntax), tokens, "{text}");
        }
    }
}
