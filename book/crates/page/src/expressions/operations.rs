//! Operators, casts and literals.

use crate::expressions::checker::{Checked, Checker};
use crate::expressions::functions::FUNCTIONS;
use crate::expressions::node::{Function, Node, Part};
use crate::expressions::refusal::{explain_operands, refuse};
use crate::expressions::types::Type;
use crate::expressions::value::Value;
use std::ops::Range;
use syn::{Expr, ExprBinary, ExprCast, ExprUnary, Lit, UnOp};

const COMPARISONS: [&str; 6] = ["==", "!=", "<", ">", "<=", ">="];

impl Checker<'_> {
    /// The row of the table with this name that takes values of these types.
    pub(super) fn find_function(&self, name: &str, kinds: &[Type]) -> Option<&'static Function> {
        FUNCTIONS.iter().find(|one| {
            let mut pairs = one.takes.iter().zip(kinds);
            one.name == name
                && one.takes.len() == kinds.len()
                && pairs.all(|(wanted, kind)| self.types.fits(kind, wanted))
        })
    }

    pub(super) fn binary(&mut self, binary: &ExprBinary) -> Checked<Part> {
        let left = self.expression(&binary.left, None)?;
        self.refuse_block_before(&binary.left, &left)?;
        let right = self.expression(&binary.right, None)?;
        let gap = &self.text[left.range.end..right.range.start];
        let start = left.range.end + gap.len() - gap.trim_start().len();
        let sign = start..start + gap.trim().len();
        let text = self.text;
        let constant = Node::Constant(Value::Bool(&text[sign.clone()] == "||"));
        if !["&&", "||"].contains(&&text[sign.clone()]) {
            return self.operate(&text[sign.clone()], sign, vec![left, right]);
        }
        let subject = format!("{} takes", &text[sign.clone()]);
        let range = left.range.start..right.range.end;
        let left = self.demand(left, &Type::Bool, &subject)?.node;
        let right = self.demand(right, &Type::Bool, &subject)?.node;
        let parts = match &text[sign] {
            "&&" => [left, right, constant],
            _ => [left, constant, right],
        };
        self.part(Node::If(Box::new(parts)), Type::Bool, range)
    }

    /// An operator with its values.
    fn operate(&mut self, name: &str, sign: Range<usize>, parts: Vec<Part>) -> Checked<Part> {
        let is_comparison = COMPARISONS.contains(&name);
        let mut kinds: Vec<_> = parts.iter().map(|part| self.types.resolve(&part.kind)).collect();
        if !is_comparison {
            kinds = kinds.into_iter().map(without_reference).collect();
        }
        while let [Type::Reference(left), Type::Reference(right)] = &kinds[..] {
            kinds = vec![(**left).clone(), (**right).clone()];
        }
        // There is none between two numbers, or truths, that are not of the same type.
        let are_plain = kinds.iter().all(|kind| kind.is_plain() || matches!(kind, Type::Open(_)));
        let are_same = !are_plain || kinds.iter().all(|kind| self.types.unify(&kinds[0], kind));
        let Some(function) = self.find_function(name, &kinds).filter(|_| are_same) else {
            let (wrong, sentence) = explain_operands(&self.types, name, &parts, self.text);
            return refuse(wrong.unwrap_or(sign), sentence);
        };
        if !are_plain {
            kinds.iter().zip(&function.takes).all(|(kind, wanted)| self.types.unify(kind, wanted));
        }
        let range = parts[0].range.start.min(sign.start)..parts[parts.len() - 1].range.end;
        let part = self.call(function, parts, sign, range)?;
        let has_kind_of_values = are_plain && !is_comparison;
        Ok(Part { kind: if has_kind_of_values { kinds.remove(0) } else { part.kind }, ..part })
    }

    pub(super) fn unary(&mut self, unary: &ExprUnary, expected: Option<&Type>) -> Checked<Part> {
        let (name, sign) = match &unary.op {
            UnOp::Neg(token) => ("neg", token.span.byte_range()),
            UnOp::Not(token) => ("!", token.span.byte_range()),
            UnOp::Deref(token) => ("*", token.span.byte_range()),
            _ => return self.refuse_unsupported(&unary.expr),
        };
        let mut inner = &*unary.expr;
        while let Expr::Paren(paren) = inner {
            inner = &paren.expr;
        }
        if let ("neg", Expr::Lit(literal)) = (name, inner) {
            let part = self.literal(&literal.lit, true, expected)?;
            let end = match &*unary.expr {
                Expr::Paren(paren) => paren.paren_token.span.join().byte_range().end,
                _ => part.range.end,
            };
            return Ok(Part { range: sign.start..end, ..part });
        }
        let part = self.expression(&unary.expr, expected.filter(|_| name != "*"))?;
        if name != "*" {
            return self.operate(name, sign, vec![part]);
        }
        match self.types.resolve(&part.kind) {
            Type::Reference(kind) => {
                Ok(Part { kind: *kind, range: sign.start..part.range.end, ..part })
            }
            _ => refuse(sign, "A value is missing before this. Powers are .powi(2)."),
        }
    }

    pub(super) fn cast(&mut self, cast: &ExprCast) -> Checked<Part> {
        let sign = cast.as_token.span.byte_range();
        let written = match &*cast.ty {
            syn::Type::Path(path) => path.path.get_ident(),
            _ => None,
        };
        let target = written.and_then(|name| Type::from_name(&name.to_string()));
        let (Some(target), Some(written)) = (target.filter(Type::is_plain), written) else {
            return refuse(sign, "Behind as: f64, i32, u32 or usize.");
        };
        let part = self.expression(&cast.expr, Some(&target))?;
        self.refuse_block_before(&cast.expr, &part)?;
        let name = format!("as {written}");
        let Some(function) = self.find_function(&name, std::slice::from_ref(&part.kind)) else {
            let kind = self.types.describe(&part.kind);
            let cure = if part.kind == Type::Bool { " f64::from(a < b) is 1 or 0." } else { "" };
            return refuse(sign, format!("{name} can't stand behind {kind}.{cure}"));
        };
        let range = part.range.start..written.span().byte_range().end;
        self.call(function, vec![part], sign, range)
    }

    /// A number, or true or false. A sign before it belongs to it: no i32 is 2147483648.
    pub(super) fn literal(
        &mut self,
        literal: &Lit,
        is_negative: bool,
        expected: Option<&Type>,
    ) -> Checked<Part> {
        let range = literal.span().byte_range();
        let (digits, suffix, has_fraction) = match literal {
            Lit::Bool(truth) if !is_negative => {
                return self.part(Node::Constant(Value::Bool(truth.value)), Type::Bool, range);
            }
            Lit::Int(number) => (number.base10_digits(), number.suffix(), false),
            Lit::Float(number) => (number.base10_digits(), number.suffix(), true),
            _ => return refuse(range, "What number is this?"),
        };
        let kind = match suffix {
            "" => {
                let kind = self.types.next_number(has_fraction);
                let _ = expected.is_some_and(|expected| self.types.unify(&kind, expected));
                self.types.resolve(&kind)
            }
            "f64" => Type::F64,
            "i32" if !has_fraction => Type::I32,
            "u32" if !has_fraction => Type::U32,
            "usize" if !has_fraction => Type::Usize,
            _ => {
                let range = range.end - suffix.len()..range.end;
                let sentence = "Something is missing before this, such as * or +. Numbers here are f64, i32, u32 or usize.";
                return refuse(range, sentence);
            }
        };
        let text = if is_negative { format!("-{digits}") } else { digits.to_owned() };
        let value = match kind {
            Type::I32 => text.parse().ok().map(Value::I32),
            Type::U32 => text.parse().ok().map(Value::U32),
            Type::Usize => text.parse().ok().map(Value::Usize),
            _ => text.parse().ok().filter(|number: &f64| number.is_finite()).map(Value::F64),
        };
        let Some(value) = value else {
            let kind = self.types.describe(&kind);
            return refuse(range, format!("That's beyond {kind}. With .0 behind it, it's none."));
        };
        self.part(Node::Constant(value), kind, range)
    }
}

/// Without the outermost reference, if there is just one.
fn without_reference(kind: Type) -> Type {
    match kind {
        Type::Reference(inner) if !matches!(*inner, Type::Reference(_)) => *inner,
        kind => kind,
    }
}
