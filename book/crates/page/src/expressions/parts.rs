//! What a line may have: each kind of syntax.

use crate::expressions::compiler::{Compiler, Part, range_of, write_tokens};
use crate::expressions::functions::functions;
use crate::expressions::node::Node;
use crate::expressions::refusal::{Checked, explain_unknown_member, explain_unknown_name, refuse};
use crate::expressions::value::Value::{self, Bool, F64, I32};
use quote::ToTokens;
use std::ops::Range;
use syn::{
    Block, Expr, ExprBinary, ExprCall, ExprField, ExprIf, ExprIndex, ExprMethodCall, ExprUnary,
    Lit, Local, LocalInit, Pat, PatIdent, ReturnType, Stmt, UnOp,
};

const UNSUPPORTED: &str = "A page can't draw with this part of Rust: it knows let, if … else, \
    blocks, arrays of three numbers, vectors and their methods.";

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
                match functions(&name).next() {
                    Some(_) => self.call(&name, vec![part], range_of(&cast.as_token)),
                    None => refuse(range_of(&cast.ty), "Behind as, there is f64 or i32."),
                }
            }
            Expr::Path(path) => self.path_call(path, vec![]),
            Expr::Field(field) => self.field(field),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::Call(call) => self.function_call(call),
            Expr::Index(index) => self.index(index),
            Expr::Array(array) => {
                let parts = array.elems.iter().map(|one| self.expression(one));
                let parts = parts.collect::<Checked<_>>()?;
                self.call("[…]", parts, range_of(syntax))
            }
            Expr::If(branches) => self.branches(branches),
            Expr::Block(block) => self.block(&block.block),
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

    /// A constant, or the call of a function, of this path.
    fn path_call(&mut self, path: &syn::ExprPath, parts: Vec<Part>) -> Checked<Part> {
        let (name, range) = (self.read_path(path)?, range_of(path));
        let (owner, method) = name.split_once("::").unwrap_or_default();
        let is_known = |name| functions(name).next().is_some();
        match (Value::from_type(owner).filter(|_| is_known(method)), parts.first()) {
            (Some(owner), Some(first)) => {
                self.demand(first, owner, &format!("{name} takes"))?;
                self.call(method, parts, range)
            }
            (None, _) if name.contains("::") && is_known(&name) => self.call(&name, parts, range),
            _ => refuse(range, explain_unknown_name(&name, &parts, self.place, self.text)),
        }
    }

    /// A path as the table of functions has it.
    fn read_path(&self, path: &impl ToTokens) -> Checked<String> {
        let name = write_tokens(path);
        if name.starts_with("DVec3") && FILES_WITHOUT_VECTORS.contains(&self.place.file) {
            return refuse(range_of(path), "This file has no use glam::DVec3.");
        }
        Ok(name)
    }

    fn function_call(&mut self, call: &ExprCall) -> Checked<Part> {
        let parts = call.args.iter().map(|one| self.expression(one)).collect::<Checked<_>>()?;
        match &*call.func {
            Expr::Path(path) if !call.args.is_empty() => self.path_call(path, parts),
            _ => refuse(range_of(call), UNSUPPORTED),
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
        let receivers = std::iter::once(&*call.receiver);
        let parts = receivers.chain(&call.args).map(|one| self.expression(one));
        let parts = parts.collect::<Checked<Vec<_>>>()?;
        if call.turbofish.is_some() {
            return refuse(range_of(&call.turbofish), "Leave out the ::<…>.");
        }
        let range = range_of(&call.dot_token).start..range_of(&call.method).end;
        self.call_member(&call.method.to_string(), parts, range)
    }

    /// The field `.NAME` or the method `NAME` of a value.
    fn call_member(&mut self, name: &str, parts: Vec<Part>, sign: Range<usize>) -> Checked<Part> {
        if parts[0].is_open {
            let sentence =
                "Rust can't tell yet which kind of number this is: write 2.0_f64 for 2.0.";
            return refuse(parts[0].range.clone(), sentence);
        }
        if functions(name).next().is_none() {
            return refuse(sign, explain_unknown_member(name, &parts[0].sample));
        }
        self.call(name, parts, sign)
    }

    /// A question about the best hit so far, whose t the page knows.
    fn best_call(&mut self, call: &ExprMethodCall) -> Checked<Part> {
        let arguments: Vec<_> = call.args.iter().collect();
        let (default, closure) = match (&*call.method.to_string(), &arguments[..]) {
            ("map_or", [default, Expr::Closure(closure)]) => (self.expression(default)?, closure),
            ("is_none_or", [Expr::Closure(closure)]) => (constant(Bool(true), false), closure),
            _ => return refuse(range_of(call), UNSUPPORTED),
        };
        let (written, output) = (write_tokens(closure), &closure.output);
        let [is_none, t] = BEST.map(|name| self.find_name(name));
        let (Some(Pat::Ident(hit)), Some(is_none), Some(t), Node::Constant(_), ReturnType::Default) =
            (closure.inputs.first(), is_none, t, &default.node, output)
        else {
            return refuse(range_of(call), UNSUPPORTED);
        };
        if !written.starts_with(&format!("|{}|", hit.ident)) {
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
        let then = self.block(&branches.then_branch)?;
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

    fn block(&mut self, block: &Block) -> Checked<Part> {
        let sentence = "A block here has let x = …; and a value at its end.";
        let Some((Stmt::Expr(value, None), statements)) = block.stmts.split_last() else {
            return refuse(range_of(block), sentence);
        };
        let (count, mut lets) = (self.names.len(), vec![]);
        for statement in statements {
            let Stmt::Local(local) = statement else {
                return refuse(range_of(statement), sentence);
            };
            lets.extend(self.declaration(local)?);
        }
        let mut part = self.expression(value)?;
        self.names.truncate(count);
        for (slot, node) in lets.into_iter().rev() {
            part.node = Node::Let(slot, Box::new([node, part.node]));
        }
        Ok(part)
    }

    /// The slot that a `let` writes and its value; None where that is the same at each pixel.
    fn declaration(&mut self, local: &Local) -> Checked<Option<(usize, Node)>> {
        let (pattern, written) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(self.read_path(&typed.ty)?)),
            pattern => (pattern, None),
        };
        let wanted = written.as_ref().map(|name| Value::from_type(name));
        let (
            Pat::Ident(PatIdent { ident, by_ref: None, subpat: None, .. }),
            Some(LocalInit { expr, diverge: None, .. }),
            None | Some(Some(_)),
        ) = (pattern, &local.init, wanted)
        else {
            return refuse(range_of(local), "A let here is let x = …; or let x: f64 = …;");
        };
        let mut part = self.expression(expr)?;
        if let Some(wanted) = wanted.flatten() {
            self.demand(&part, wanted, "This let takes")?;
            part.is_open = false;
        }
        if part.node.is_constant() {
            self.add_name(ident, "", part)?;
            return Ok(None);
        }
        let slot = self.slots;
        let named_part = self.new_slot(part.sample, part.is_open);
        self.add_name(ident, "", named_part)?;
        Ok(Some((slot, part.node)))
    }
}

/// A number, or true or false.
fn literal_part(literal: &Lit) -> Checked<Part> {
    let (sample, suffix) = match literal {
        Lit::Bool(truth) => (Some(Bool(truth.value)), "bool"),
        Lit::Int(number) => (number.base10_parse().map(I32).ok(), number.suffix()),
        Lit::Float(number) => (number.base10_parse().map(F64).ok(), number.suffix()),
        _ => (None, ""),
    };
    match (sample, suffix) {
        (Some(sample @ (F64(f64::MIN..=f64::MAX) | I32(_))), "") => Ok(constant(sample, true)),
        (Some(sample @ F64(f64::MIN..=f64::MAX)), "f64") => Ok(constant(sample, false)),
        (Some(sample @ I32(_)), "i32") | (Some(sample), "bool") => Ok(constant(sample, false)),
        _ => refuse(range_of(literal), "Rust has no such f64 or i32; or is a * missing?"),
    }
}

fn constant(sample: Value, is_open: bool) -> Part {
    Part { node: Node::Constant(sample), sample, is_open, range: 0..0 }
}
