use crate::expressions::refusal::{Checked, refuse};
use quote::ToTokens;
use std::iter::once;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::{Expr, UnOp};

const UNSUPPORTED: &str = "A page can't draw with this part of Rust: it knows let, if … else, \
    blocks, arrays of three numbers, vectors and their methods.";

/// A function under its name in the table, the parts of a text that it takes, and where its name or
/// its sign stands.
type Operation<'a> = (String, Vec<&'a Expr>, Range<usize>);

/// The bytes of a part of the text.
pub fn range_of(syntax: &impl Spanned) -> Range<usize> {
    syntax.span().byte_range()
}

/// A part of the text without blanks and comments.
pub fn write_tokens(syntax: &impl ToTokens) -> String {
    syntax.to_token_stream().to_string().split_whitespace().collect()
}

/// The function or operator that this syntax calls, and its operands.
pub fn split_operation(syntax: &Expr) -> Checked<Operation<'_>> {
    Ok(match syntax {
        Expr::Unary(unary) => {
            let sign = range_of(&unary.op);
            if let UnOp::Deref(_) = unary.op {
                return refuse(sign, "A value is missing before this. Powers are .powi(2).");
            }
            (write_tokens(&unary.op), vec![&*unary.expr], sign)
        }
        Expr::Binary(binary) => {
            let operands = vec![&*binary.left, &*binary.right];
            (write_tokens(&binary.op), operands, range_of(&binary.op))
        }
        Expr::Cast(cast) => {
            let name = format!("as {}", write_tokens(&cast.ty));
            (name, vec![&*cast.expr], range_of(&cast.as_token))
        }
        Expr::Array(array) => ("[…]".to_owned(), array.elems.iter().collect(), range_of(array)),
        Expr::Index(index) => {
            let name = format!("[{}]", write_tokens(&index.index));
            (name, vec![&*index.expr], range_of(&index.bracket_token.span.join()))
        }
        Expr::Field(field) => {
            let sign = range_of(&field.dot_token).start..range_of(field).end;
            (format!(".{}", write_tokens(&field.member)), vec![&*field.base], sign)
        }
        Expr::MethodCall(call) => {
            let name = format!("::{}{}", call.method, write_tokens(&call.turbofish));
            let sign = range_of(&call.dot_token).start..range_of(&call.method).end;
            (name, once(&*call.receiver).chain(&call.args).collect(), sign)
        }
        Expr::Path(path) => (write_tokens(path), vec![], range_of(path)),
        Expr::Call(call) if !call.args.is_empty() => {
            (write_tokens(&call.func), call.args.iter().collect(), range_of(&call.func))
        }
        Expr::Reference(one) => return refuse(range_of(&one.and_token), "Leave out the &."),
        Expr::Assign(one) => {
            return refuse(range_of(&one.eq_token), "For =, Rust has == to compare.");
        }
        _ => return refuse(range_of(syntax), UNSUPPORTED),
    })
}
