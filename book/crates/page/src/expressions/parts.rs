//! What a line may have: each kind of syntax.

use crate::expressions::compiler::{Compiler, Part, range_of, write_tokens};
use crate::expressions::functions::is_known;
use crate::expressions::node::Node;
use crate::expressions::refusal::{Checked, explain_unknown_member, explain_unknown_name, refuse};
use crate::expressions::value::Value::{self, Bool, F64, I32};
use std::ops::Range;
use syn::{
    Expr, ExprBinary, ExprCall, ExprField, ExprIf, ExprIndex, ExprMethodCall, ExprPath, ExprUnary,
    Lit, LocalInit, Pat, PatIdent, Stmt, UnOp,
};

const UNSUPPORTED: &str = "A page can't draw with this part of Rust: it knows let, if … else, \
    blocks, arrays of three numbers, vectors and their methods.";

const BLOCK: &str = "A block here has let x = …; and a value at its end.";

/// Questions of a step about its best hit so far, as `places.txt` has them.
const BEST: [&str; 2] = ["best.is_none()", "best.as_ref().map_or(f64::INFINITY,|hit|hit.t)"];

/// Files without `use glam::DVec3`.
const FILES_WITHOUT_VECTORS: [&str; 2] =
    ["step02_sphere/src/quadratic.rs", "step03_nearest/src/nearest.rs"];

impl Compiler<'_> {
    /// Compiles syntax that isn't the name of a value.
    pub fn compile(&mut self, syntax: &Expr) -> Checked<Part> {
        match syntax {
            Expr::Lit(literal) => literal_part(&literal.lit),
            Expr::Paren(paren) => self.expression(&paren.expr),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Cast(cast) => {
                let part = self.expression(&cast.expr)?;
                let name = format!("as {}", write_tokens(&cast.ty));
                self.call(&name, vec![part], range_of(&cast.as_token))
            }
            Expr::Path(path) => self.path_call(path, vec![]),
            Expr::Field(field) => self.field(field),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::Call(ExprCall { func, args, .. }) => match &**func {
                Expr::Path(path) if !args.is_empty() => {
                    let parts = self.expressions(args)?;
                    self.path_call(path, parts)
                }
                _ => refuse(range_of(func), UNSUPPORTED),
            },
            Expr::Index(index) => self.index(index),
            Expr::Array(array) if array.elems.len() == 3 => {
                let parts = self.expressions(&array.elems)?;
                self.call("[…]", parts, range_of(syntax))
            }
            Expr::Array(_) => refuse(range_of(syntax), "An array here has three numbers."),
            Expr::If(branches) => self.branches(branches),
            Expr::Block(block) => self.block(&block.block.stmts, range_of(block)),
            Expr::Reference(one) => refuse(range_of(&one.and_token), "Leave out the &."),
            Expr::Assign(one) => refuse(range_of(&one.eq_token), "For =, Rust has == to compare."),
            _ => refuse(range_of(syntax), UNSUPPORTED),
        }
    }

    fn unary(&mut self, unary: &ExprUnary) -> Checked<Part> {
        let sign = range_of(&unary.op);
        if let UnOp::Deref(_) = unary.op {
            return refuse(sign, "A value is missing before this. Powers are .powi(2).");
        }
        let part = self.expression(&unary.expr)?;
        self.call(&write_tokens(&unary.op), vec![part], sign)
    }

    fn binary(&mut self, binary: &ExprBinary) -> Checked<Part> {
        let [left, right] = [self.expression(&binary.left)?, self.expression(&binary.right)?];
        let name = write_tokens(&binary.op);
        if name != "&&" && name != "||" {
            return self.call(&name, vec![left, right], range_of(&binary.op));
        }
        for part in [&left, &right] {
            self.demand(part, Bool(true), &format!("{name} takes"))?;
        }
        let other = Node::Constant(Bool(name == "||"));
        let nodes = match &*name {
            "&&" => [left.node, right.node, other],
            _ => [left.node, other, right.node],
        };
        Ok(Part { node: Node::If(Box::new(nodes)), ..right })
    }

    fn expressions<'a>(&mut self, all: impl IntoIterator<Item = &'a Expr>) -> Checked<Vec<Part>> {
        all.into_iter().map(|syntax| self.expression(syntax)).collect()
    }

    /// A constant, or the call of a function, of this path.
    fn path_call(&mut self, path: &ExprPath, parts: Vec<Part>) -> Checked<Part> {
        let (name, range) = (write_tokens(path), range_of(path));
        if name.starts_with("DVec3") && FILES_WITHOUT_VECTORS.contains(&self.place.file) {
            return refuse(range, "This file has no use glam::DVec3.");
        }
        let (owner, method) = name.split_once("::").unwrap_or_default();
        match (Value::from_type(owner).filter(|_| is_known(method)), parts.first()) {
            (Some(owner), Some(first)) => {
                self.demand(first, owner, &format!("{name} takes"))?;
                self.call(method, parts, range)
            }
            (None, _) if name.contains("::") && is_known(&name) => self.call(&name, parts, range),
            _ => refuse(range, explain_unknown_name(&name, &parts, self.place, self.text)),
        }
    }

    fn field(&mut self, field: &ExprField) -> Checked<Part> {
        let base_range = range_of(&field.base);
        let base = self.expression(&field.base).or_else(|refusal| {
            // What is not known is named whole, such as `sphere.center`.
            if refusal.range == base_range && !write_tokens(&field.base).contains(['(', ':']) {
                let name = write_tokens(field);
                let sentence = explain_unknown_name(&name, &[], self.place, self.text);
                return refuse(range_of(field), sentence);
            }
            Err(refusal)
        })?;
        let range = base_range.end..range_of(field).end;
        self.call_member(&format!(".{}", write_tokens(&field.member)), vec![base], range)
    }

    fn method_call(&mut self, call: &ExprMethodCall) -> Checked<Part> {
        if write_tokens(&call.receiver) == "best.as_ref()" {
            return self.best_call(call);
        }
        let parts = self.expressions(std::iter::once(&*call.receiver).chain(&call.args))?;
        let range = range_of(&call.dot_token).start..range_of(&call.method).end;
        let name = call.method.to_string() + &write_tokens(&call.turbofish);
        self.call_member(&name, parts, range)
    }

    /// The field `.NAME` or the method `NAME` of a value.
    fn call_member(&mut self, name: &str, parts: Vec<Part>, sign: Range<usize>) -> Checked<Part> {
        if parts[0].is_open {
            let sentence =
                "Rust can't tell yet which kind of number this is: write 2.0_f64 for 2.0.";
            return refuse(parts[0].range.clone(), sentence);
        }
        if !is_known(name) {
            return refuse(sign, explain_unknown_member(name, &parts[0].sample));
        }
        self.call(name, parts, sign)
    }

    /// A question about the best hit so far, whose t the page knows.
    fn best_call(&mut self, call: &ExprMethodCall) -> Checked<Part> {
        let arguments: Vec<_> = call.args.iter().collect();
        let truth = Part::new(Node::Constant(Bool(true)), Bool(true), false);
        let (default, closure) = match (&*call.method.to_string(), &arguments[..]) {
            ("map_or", [default, Expr::Closure(closure)]) => (self.expression(default)?, closure),
            ("is_none_or", [Expr::Closure(closure)]) => (truth, closure),
            _ => return refuse(range_of(call), UNSUPPORTED),
        };
        let [is_none, t] = BEST.map(|name| self.find_name(name));
        let (Some(Pat::Ident(hit)), Some(is_none), Some(t), Node::Constant(_)) =
            (closure.inputs.first(), is_none, t, &default.node)
        else {
            return refuse(range_of(call), UNSUPPORTED);
        };
        // Neither types nor further words.
        if write_tokens(closure) != format!("|{}|{}", hit.ident, write_tokens(&closure.body)) {
            return refuse(range_of(call), UNSUPPORTED);
        }
        self.add_name(&hit.ident, ".t", t)?;
        let body = self.expression(&closure.body)?;
        self.names.pop();
        self.demand(&body, default.sample, "The closure gives")?;
        Ok(Part { node: Node::If(Box::new([is_none.node, default.node, body.node])), ..body })
    }

    fn index(&mut self, index: &ExprIndex) -> Checked<Part> {
        let parts = vec![self.expression(&index.expr)?, self.expression(&index.index)?];
        let sign = range_of(&index.bracket_token.span.join());
        match (&*index.index, &parts[1]) {
            (Expr::Lit(_), Part { sample: I32(0..=2), is_open: true, .. }) => {
                self.call("[]", parts, sign)
            }
            _ => refuse(sign, "An index here is [0], [1] or [2]."),
        }
    }

    fn branches(&mut self, branches: &ExprIf) -> Checked<Part> {
        let condition = self.expression(&branches.cond)?;
        self.demand(&condition, Bool(true), "An if takes")?;
        let then = &branches.then_branch;
        let then = self.block(&then.stmts, range_of(then))?;
        let Some((_, other)) = &branches.else_branch else {
            let sentence = "This if needs an else { … }: what is the value otherwise?";
            return refuse(range_of(&branches.if_token), sentence);
        };
        let other = self.expression(other)?;
        self.demand(&other, then.sample, "As before the else, here belongs")?;
        let is_open = then.is_open && other.is_open;
        let node = Node::If(Box::new([condition.node, then.node, other.node]));
        Ok(Part { node, is_open, ..then })
    }

    /// The value of these statements, the last of a block.
    fn block(&mut self, statements: &[Stmt], range: Range<usize>) -> Checked<Part> {
        let (local, rest) = match statements {
            [Stmt::Expr(value, None)] => return self.expression(value),
            [Stmt::Local(local), rest @ ..] => (local, rest),
            _ => return refuse(range, BLOCK),
        };
        let (
            Pat::Ident(PatIdent { ident, by_ref: None, subpat: None, .. }),
            Some(LocalInit { expr, diverge: None, .. }),
        ) = (&local.pat, &local.init)
        else {
            return refuse(range, BLOCK);
        };
        let value = self.expression(expr)?;
        let (slot, is_constant) = (self.slots, value.node.is_constant());
        let named_part = match is_constant {
            true => value.clone(),
            false => self.new_slot(value.sample, value.is_open),
        };
        self.add_name(ident, "", named_part)?;
        let mut part = self.block(rest, range)?;
        self.names.pop();
        if !is_constant {
            part.node = Node::Let(slot, Box::new([value.node, part.node]));
        }
        Ok(part)
    }
}

/// A number, or true or false.
fn literal_part(literal: &Lit) -> Checked<Part> {
    let sample = match literal {
        Lit::Bool(truth) => Some(Bool(truth.value)),
        Lit::Int(number) => number.base10_parse().map(I32).ok(),
        Lit::Float(number) => number.base10_parse().map(F64).ok(),
        _ => None,
    };
    let is_open = literal.suffix().is_empty();
    match (sample, literal.suffix()) {
        (Some(F64(f64::INFINITY)), _) => refuse(range_of(literal), "That's beyond an f64."),
        (Some(sample), "") | (Some(sample @ I32(_)), "i32") | (Some(sample @ F64(_)), "f64") => {
            Ok(Part::new(Node::Constant(sample), sample, is_open))
        }
        _ => refuse(range_of(literal), "Rust has no such f64 or i32; or is a * missing?"),
    }
}
