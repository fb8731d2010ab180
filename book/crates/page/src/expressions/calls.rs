//! Operators, casts, and calls of methods and functions: all are rows of one table.

use crate::expressions::checker::{Checked, Checker, chain_range};
use crate::expressions::functions::FUNCTIONS;
use crate::expressions::node::{Function, Node, Part};
use crate::expressions::refusal::{
    ASSOCIATED, explain_open_number, explain_refused_call, explain_unknown_function,
    explain_unknown_member, refuse,
};
use crate::expressions::types::Type;
use crate::expressions::value::Value;
use std::ops::Range;
use syn::punctuated::Punctuated;
use syn::{Expr, ExprBinary, ExprCall, ExprCast, ExprMethodCall, ExprUnary, Pat, Token, UnOp};

type Arguments = Punctuated<Expr, Token![,]>;

const COMPARISONS: [&str; 6] = ["==", "!=", "<", ">", "<=", ">="];

/// Questions of a step about its best hit so far, as `places.txt` has them.
const BEST: [&str; 2] = ["best.is_none()", "best.as_ref().map_or(f64::INFINITY,|hit|hit.t)"];

impl Checker<'_> {
    /// The call of a function, an operator or a cast, whose name is at `sign`.
    pub(super) fn call(
        &mut self,
        name: &str,
        parts: Vec<Part>,
        sign: Range<usize>,
        range: Range<usize>,
    ) -> Checked<Part> {
        let is_operator = !name.contains(char::is_alphanumeric);
        let is_comparison = COMPARISONS.contains(&name);
        let mut kinds: Vec<_> = parts.iter().map(|part| part.kind.clone()).collect();
        let are_references = kinds.iter().all(|kind| matches!(kind, Type::Reference(_)));
        if is_operator && (are_references || !is_comparison) {
            kinds = kinds.into_iter().map(without_reference).collect();
        }
        // There is no operator between two numbers, or truths, that are not of the same type.
        let are_plain = is_operator && kinds.iter().all(Type::is_plain);
        let joined = Type::join(kinds.iter()).filter(|_| are_plain);
        if let Some(joined) = &joined {
            kinds.fill(joined.clone());
        }
        let rows: Vec<_> = FUNCTIONS.iter().filter(|row| row.name == name).collect();
        let fits = |row: &&&Function| {
            let mut pairs = row.takes.iter().zip(&kinds);
            row.takes.len() == kinds.len() && pairs.all(|(wanted, kind)| kind.fits(wanted))
        };
        let function = rows.iter().find(fits).filter(|_| joined.is_some() || !are_plain);
        let Some(function) = function else {
            let shown_name = if name.starts_with("as ") { name } else { &self.text[sign.clone()] };
            let (wrong, sentence) = explain_refused_call(shown_name, &rows, &parts, self.text);
            return refuse(wrong.unwrap_or(sign), sentence);
        };
        let mut nodes = vec![];
        for (part, wanted) in parts.into_iter().zip(&function.takes) {
            let is_open = part.kind == Type::OpenWhole;
            nodes.push(if is_open { self.demand(part, wanted, "")?.node } else { part.node });
        }
        // Rust refuses to divide by a 0 that it knows, whatever is divided.
        if let ("/" | "%", [_, Node::Constant(divisor)]) = (name, &nodes[..])
            && let Value::Stop(sentence) = (function.apply)(&[Value::Bool(false), divisor.clone()])
        {
            return refuse(sign, sentence);
        }
        let kind = joined.filter(|_| !is_comparison).unwrap_or(function.gives.clone());
        self.part(Node::Call(function, nodes, sign), kind, range)
    }

    pub(super) fn binary(&mut self, binary: &ExprBinary) -> Checked<Part> {
        let left = self.expression(&binary.left)?;
        self.refuse_block_before(&binary.left, &left)?;
        let right = self.expression(&binary.right)?;
        let range = left.range.start..right.range.end;
        let gap = &self.text[left.range.end..right.range.start];
        let start = left.range.end + gap.len() - gap.trim_start().len();
        let (name, sign) = (gap.trim(), start..start + gap.trim().len());
        if !["&&", "||"].contains(&name) {
            return self.call(name, vec![left, right], sign, range);
        }
        let subject = format!("{name} takes");
        let left = self.demand(left, &Type::Bool, &subject)?.node;
        let right = self.demand(right, &Type::Bool, &subject)?.node;
        let constant = Node::Constant(Value::Bool(name == "||"));
        let parts = match name {
            "&&" => vec![left, right, constant],
            _ => vec![left, constant, right],
        };
        self.part(Node::If(parts), Type::Bool, range)
    }

    pub(super) fn unary(&mut self, unary: &ExprUnary) -> Checked<Part> {
        let (name, sign) = match &unary.op {
            UnOp::Neg(token) => ("-", token.span.byte_range()),
            UnOp::Not(token) => ("!", token.span.byte_range()),
            UnOp::Deref(token) => ("*", token.span.byte_range()),
            _ => return self.refuse_unsupported(&unary.expr),
        };
        let part = self.expression(&unary.expr)?;
        let range = sign.start..part.range.end;
        match (name, part.kind.clone(), &part.node) {
            ("*", Type::Reference(kind), _) => Ok(Part { kind: *kind, range, ..part }),
            ("*", ..) => refuse(sign, "A value is missing before this. Powers are .powi(2)."),
            // A sign belongs to its number: no i32 is 2147483648.
            ("-", kind, Node::Constant(Value::Whole(number))) => match number {
                1.. => Ok(Part { node: Node::Constant(Value::Whole(-number)), kind, range }),
                _ => refuse(sign, "This sign is one too many."),
            },
            _ => self.call(name, vec![part], sign, range),
        }
    }

    pub(super) fn cast(&mut self, cast: &ExprCast) -> Checked<Part> {
        let sign = cast.as_token.span.byte_range();
        let Some(target) = self.written_type(&cast.ty).filter(Type::is_plain) else {
            return refuse(sign, "Behind as: f64, i32, u32 or usize.");
        };
        let blanks = self.text[sign.end..].find(target.name()).unwrap_or_default();
        let end = sign.end + blanks + target.name().len();
        let mut part = self.expression(&cast.expr)?;
        self.refuse_block_before(&cast.expr, &part)?;
        if part.kind == Type::OpenWhole && target.is_whole() {
            part = self.demand(part, &target, "")?;
        }
        let range = part.range.start..end;
        self.call(&format!("as {}", target.name()), vec![part], sign, range)
    }

    pub(super) fn method_call(&mut self, call: &ExprMethodCall) -> Checked<Part> {
        let method = call.method.to_string();
        let sign = call.dot_token.span.byte_range().start..call.method.span().byte_range().end;
        let end = call.paren_token.span.join().byte_range().end;
        if let Some(range) = chain_range(&call.receiver)
            && self.text[range.clone()] == *"best.as_ref()"
            && let Some(part) = self.best_call(&method, &call.args, range.start..end)?
        {
            return Ok(part);
        }
        let receiver = self.expression(&call.receiver)?;
        if call.turbofish.is_some() {
            return refuse(sign, "Leave out the ::<…>.");
        }
        let arguments: Checked<_> = call.args.iter().map(|one| self.expression(one)).collect();
        self.call_member(&format!("::{method}"), receiver, arguments?, sign, end)
    }

    /// The field `.NAME` or the method `::NAME` of a value.
    pub(super) fn call_member(
        &mut self,
        member: &str,
        receiver: Part,
        arguments: Vec<Part>,
        sign: Range<usize>,
        end: usize,
    ) -> Checked<Part> {
        let kind = receiver.kind.referent().clone();
        if let Type::OpenF64 | Type::OpenI32 | Type::OpenWhole = kind {
            let sentence = explain_open_number(&self.text[receiver.range.clone()]);
            return refuse(receiver.range, sentence);
        }
        let name = format!("{}{member}", kind.name());
        let is_associated = ASSOCIATED.contains(&member.trim_start_matches(':'));
        if is_associated || FUNCTIONS.iter().all(|row| row.name != name) {
            return refuse(sign, explain_unknown_member(member, &kind));
        }
        let range = receiver.range.start..end;
        let receiver = Part { kind, ..receiver };
        let parts = std::iter::once(receiver).chain(arguments).collect();
        self.call(&name, parts, sign, range)
    }

    /// A call such as `f64::max(a, b)`.
    pub(super) fn function_call(&mut self, call: &ExprCall) -> Checked<Part> {
        let sign = chain_range(&call.func).unwrap_or(0..self.text.len());
        let range = sign.start..call.paren_token.span.join().byte_range().end;
        let name = self.table_name(sign.clone())?;
        if FUNCTIONS.iter().any(|row| row.name == name && !row.takes.is_empty()) {
            let parts: Checked<_> = call.args.iter().map(|one| self.expression(one)).collect();
            return self.call(&name, parts?, sign, range);
        }
        let first = call.args.first().and_then(chain_range).map_or("a", |range| &self.text[range]);
        match explain_unknown_function(&name, first, call.args.len()) {
            Some(sentence) => refuse(sign, sentence),
            None => self.refuse_unknown(sign),
        }
    }

    /// A question about the best hit so far, whose t the page knows.
    fn best_call(
        &mut self,
        method: &str,
        arguments: &Arguments,
        range: Range<usize>,
    ) -> Checked<Option<Part>> {
        let node = |text| self.names.iter().find(|one| one.0 == text).map(|one| one.2.clone());
        let [Some(is_none), Some(t)] = BEST.map(node) else { return Ok(None) };
        let arguments: Vec<_> = arguments.iter().collect();
        let (default, closure) = match (method, &arguments[..]) {
            ("map_or", [default, Expr::Closure(closure)]) => (self.expression(default)?, closure),
            ("is_none_or" | "is_some_and", [Expr::Closure(closure)]) => {
                (self.truth(method == "is_none_or", range.clone())?, closure)
            }
            _ => return Ok(None),
        };
        let (Some(Pat::Ident(hit)), 1) = (closure.inputs.first(), closure.inputs.len()) else {
            return Ok(None);
        };
        self.add_name(&hit.ident, ".t", Type::F64, t)?;
        let body = self.expression(&closure.body);
        self.names.pop();
        let (mut nodes, kind) = self.join(vec![default, body?], method)?;
        // Both are evaluated, though one is needed: as in Rust.
        let local = self.locals;
        self.locals += 1;
        let default = std::mem::replace(&mut nodes[0], Node::Local(local));
        nodes.insert(0, is_none);
        let nodes = vec![Node::Let(local, Box::new(default)), Node::If(nodes)];
        self.part(Node::Block(nodes), kind, range).map(Some)
    }
}

/// Without the outermost reference, if there is just one.
fn without_reference(kind: Type) -> Type {
    match kind {
        Type::Reference(inner) if !matches!(*inner, Type::Reference(_)) => *inner,
        kind => kind,
    }
}
