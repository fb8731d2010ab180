//! Literals, blocks, branches, arrays, references, and all that no line can have.

use crate::expressions::checker::{Checked, Checker};
use crate::expressions::node::{Node, Part};
use crate::expressions::refusal::{explain_refused_call, refuse};
use crate::expressions::types::Type;
use crate::expressions::value::Value;
use std::ops::Range;
use syn::{Block, Expr, ExprArray, ExprIf, ExprIndex, ExprReference, Lit, Local, Pat, Stmt};

const LET: &str = "A let here is let x = …; or let x: f64 = …;";

impl Checker<'_> {
    /// A number, or true or false.
    pub(super) fn literal(&mut self, literal: &Lit) -> Checked<Part> {
        let range = literal.span().byte_range();
        let (digits, suffix, open) = match literal {
            Lit::Bool(truth) => return self.truth(truth.value, range),
            Lit::Int(number) => (number.base10_digits(), number.suffix(), Type::OpenWhole),
            Lit::Float(number) => (number.base10_digits(), number.suffix(), Type::OpenF64),
            _ => return refuse(range, "What number is this?"),
        };
        let kind = match Type::from_name(suffix) {
            None if suffix.is_empty() => open,
            Some(kind) if kind == Type::F64 || open.fits(&kind) => kind,
            _ => {
                let range = range.end - suffix.len()..range.end;
                return refuse(range, "Numbers are f64, i32, u32 or usize; or is a * missing?");
            }
        };
        let (value, open) = match kind.is_whole() {
            true => (digits.parse().ok().map(Value::Whole), Type::OpenWhole),
            false => (digits.parse().ok().map(Value::F64), Type::OpenF64),
        };
        match value.filter(|value| !matches!(value, Value::F64(number) if number.is_infinite())) {
            Some(value) => {
                let part = self.part(Node::Constant(value), open, range)?;
                self.demand(part, &kind, "")
            }
            None => refuse(range, format!("That's beyond {}.", kind.describe())),
        }
    }

    pub(super) fn truth(&mut self, truth: bool, range: Range<usize>) -> Checked<Part> {
        self.part(Node::Constant(Value::Bool(truth)), Type::Bool, range)
    }

    pub(super) fn branches(&mut self, branches: &ExprIf) -> Checked<Part> {
        let sign = branches.if_token.span.byte_range();
        let condition = self.expression(&branches.cond)?;
        let condition = self.demand(condition, &Type::Bool, "An if takes")?;
        let then = self.block(&branches.then_branch)?;
        let Some((_, other)) = &branches.else_branch else {
            return refuse(sign, "This if needs an else { … }: what is the value otherwise?");
        };
        let other = self.expression(other)?;
        let range = sign.start..other.range.end;
        let (mut nodes, kind) = self.join(vec![then, other], "if … else")?;
        nodes.insert(0, condition.node);
        self.part(Node::If(nodes), kind, range)
    }

    pub(super) fn block(&mut self, block: &Block) -> Checked<Part> {
        let range = block.brace_token.span.join().byte_range();
        let count = self.names.len();
        let (mut nodes, mut kind) = (vec![], Type::Unit);
        for (index, statement) in block.stmts.iter().enumerate() {
            match statement {
                Stmt::Local(local) => nodes.push(self.declaration(local)?),
                Stmt::Expr(syntax, Some(_)) => nodes.push(self.expression(syntax)?.node),
                Stmt::Expr(syntax, None) if index + 1 == block.stmts.len() => {
                    let tail = self.expression(syntax)?;
                    let tail = if nodes.is_empty() { tail } else { self.close_whole(tail)? };
                    kind = tail.kind;
                    if let Type::Reference(_) = kind {
                        return refuse(tail.range, "A block gives no reference: leave out the &.");
                    }
                    nodes.push(tail.node);
                }
                _ => return refuse(range, "A block here has let x = …; and a value at its end."),
            }
        }
        self.names.truncate(count);
        self.part(Node::Block(nodes), kind, range)
    }

    fn declaration(&mut self, local: &Local) -> Checked<Node> {
        let (pattern, written) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(self.written_type(&typed.ty))),
            pattern => (pattern, None),
        };
        let (Pat::Ident(name), Some(init)) = (pattern, &local.init) else {
            return refuse(local.let_token.span.byte_range(), LET);
        };
        if written == Some(None) || name.by_ref.is_some() || init.diverge.is_some() {
            return refuse(local.let_token.span.byte_range(), LET);
        }
        let part = self.expression(&init.expr)?;
        let part = match written.flatten() {
            Some(written) => self.demand(part, &written, "This let takes")?,
            None => self.close_whole(part)?,
        };
        if part.node.is_constant() {
            self.add_name(&name.ident, "", part.kind, part.node.clone())?;
            return Ok(part.node);
        }
        let local = self.locals;
        self.locals += 1;
        self.add_name(&name.ident, "", part.kind, Node::Local(local))?;
        Ok(Node::Let(local, Box::new(part.node)))
    }

    /// A type that is written, if a line can have it.
    pub(super) fn written_type(&self, written: &syn::Type) -> Option<Type> {
        let syn::Type::Path(path) = written else { return None };
        let name = self.table_name(path.path.get_ident()?.span().byte_range()).ok()?;
        Type::from_name(&name).filter(|kind| *kind != Type::Attenuation)
    }

    pub(super) fn array(&mut self, array: &ExprArray) -> Checked<Part> {
        let range = array.bracket_token.span.join().byte_range();
        let parts: Checked<Vec<_>> = array.elems.iter().map(|one| self.expression(one)).collect();
        let (nodes, item) = self.join(parts?, "[…]")?;
        let kind = Type::Array(Box::new(item), nodes.len());
        self.part(Node::Array(nodes), kind, range)
    }

    /// Parts that have to be of one type, and that type.
    pub(super) fn join(&mut self, parts: Vec<Part>, name: &str) -> Checked<(Vec<Node>, Type)> {
        let Some(kind) = Type::join(parts.iter().map(|part| &part.kind)) else {
            let (wrong, sentence) = explain_refused_call(name, &[], &parts, self.text);
            return refuse(wrong.unwrap_or(0..self.text.len()), sentence);
        };
        let nodes = parts.into_iter().map(|part| Ok(self.demand(part, &kind, "")?.node));
        Ok((nodes.collect::<Checked<_>>()?, kind))
    }

    /// A part with the type that Rust gives it if nothing else does.
    fn close_whole(&self, part: Part) -> Checked<Part> {
        if part.kind == Type::OpenWhole { self.demand(part, &Type::OpenI32, "") } else { Ok(part) }
    }

    pub(super) fn index(&mut self, index: &ExprIndex) -> Checked<Part> {
        let sign = index.bracket_token.span.join().byte_range();
        let mut base = self.expression(&index.expr)?;
        self.refuse_block_before(&index.expr, &base)?;
        let range = base.range.start..sign.end;
        let position = self.expression(&index.index)?;
        let position = self.demand(position, &Type::Usize, "An index is")?;
        if *base.kind.referent() == Type::DVec3 {
            base = self.call_member("::to_array", base, vec![], sign.clone(), sign.end)?;
        }
        match (base.kind.referent(), &position.node) {
            (Type::Array(_, length), Node::Constant(Value::Usize(at))) if *length as u64 <= *at => {
                refuse(sign, format!("It has {length} elements; the first is [0]."))
            }
            (Type::Array(item, _), _) => {
                let node = Node::Index(vec![base.node, position.node], sign);
                self.part(node, (**item).clone(), range)
            }
            _ => refuse(sign, "Vectors and arrays have elements, and this is none."),
        }
    }

    pub(super) fn reference(&mut self, reference: &ExprReference) -> Checked<Part> {
        let sign = reference.and_token.span.byte_range();
        if reference.mutability.is_some() {
            return refuse(sign, "References here are without mut.");
        }
        let part = self.expression(&reference.expr)?;
        let part = self.close_whole(part)?;
        let range = sign.start..part.range.end;
        Ok(Part { kind: Type::Reference(Box::new(part.kind)), range, ..part })
    }

    /// Refuses a block before an operator where a statement begins: Rust takes it for the whole.
    pub(super) fn refuse_block_before(&self, syntax: &Expr, part: &Part) -> Checked<()> {
        let text_before = self.text[..part.range.start].trim_end();
        let is_start = text_before.is_empty() || text_before.ends_with(['{', '}', ';']);
        if is_start && matches!(syntax, Expr::If(_) | Expr::Block(_)) {
            return refuse(part.range.clone(), "Put parentheses around this block.");
        }
        Ok(())
    }

    /// Refuses syntax that Rust has, and a line here has not.
    pub(super) fn refuse_unsupported<T>(&self, syntax: &Expr) -> Checked<T> {
        let (span, syntax_name) = match syntax {
            Expr::Assign(one) => {
                return refuse(one.eq_token.span.byte_range(), "For =, Rust has == to compare.");
            }
            Expr::Closure(one) => (one.or1_token.span, "a closure"),
            Expr::Match(one) => (one.match_token.span, "a match"),
            Expr::Let(one) => (one.let_token.span, "if let, or let without a block"),
            Expr::Tuple(one) => (one.paren_token.span.join(), "a tuple"),
            _ => return refuse(0..self.text.len(), "A page can't draw with this part of Rust."),
        };
        let sentence = format!(
            "A page can't draw with {syntax_name}: it knows let, if … else, blocks, arrays, references, \
             numbers, vectors and their methods."
        );
        refuse(span.byte_range(), sentence)
    }
}
