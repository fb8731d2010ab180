//! Blocks, branches, arrays, references, and all that no line can have.

use crate::expressions::checker::{Checked, Checker};
use crate::expressions::node::{Node, Part};
use crate::expressions::refusal::refuse;
use crate::expressions::types::Type;
use crate::expressions::value::Value;
use proc_macro2::Span;
use syn::{Block, Expr, ExprArray, ExprIf, ExprIndex, ExprReference, Local, Pat, Stmt};

impl Checker<'_> {
    pub(super) fn branches(&mut self, branches: &ExprIf, expected: Option<&Type>) -> Checked<Part> {
        let sign = branches.if_token.span.byte_range();
        let condition = self.value(&branches.cond, &Type::Bool, "An if takes")?;
        let then = self.block(&branches.then_branch, expected)?;
        let Some((_, other)) = &branches.else_branch else {
            return refuse(sign, "This if needs an else { … }: what is the value otherwise?");
        };
        let other = self.expression(other, expected)?;
        let other = self.demand(other, &then.kind, "As in the branch before, here belongs")?;
        let node = Node::If(Box::new([condition.node, then.node, other.node]));
        self.part(node, then.kind, sign.start..other.range.end)
    }

    pub(super) fn block(&mut self, block: &Block, expected: Option<&Type>) -> Checked<Part> {
        let range = block.brace_token.span.join().byte_range();
        let count = self.names.len();
        let (mut nodes, mut kind) = (vec![], Type::Unit);
        for (index, statement) in block.stmts.iter().enumerate() {
            let is_last = index + 1 == block.stmts.len();
            match statement {
                Stmt::Local(local) => nodes.push(self.declaration(local)?),
                Stmt::Expr(syntax, Some(_)) => nodes.push(self.expression(syntax, None)?.node),
                Stmt::Expr(syntax, None) if is_last => {
                    let tail = self.expression(syntax, expected)?;
                    kind = self.types.resolve(&tail.kind);
                    if let Type::Reference(_) = kind {
                        let sentence = "A block can't give a reference away: leave out the &.";
                        return refuse(tail.range, sentence);
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
        let (Pat::Ident(name), Some(init), None | Some(Some(_))) = (pattern, &local.init, &written)
        else {
            let range = local.let_token.span.byte_range();
            return refuse(range, "A let here is let x = …; or let x: f64 = …;");
        };
        let part = match written.flatten() {
            Some(written) => self.value(&init.expr, &written, "This let takes")?,
            None => self.expression(&init.expr, None)?,
        };
        if name.by_ref.is_some() || name.subpat.is_some() || init.diverge.is_some() {
            return refuse(part.range, "A let here is let x = …; or let x: f64 = …;");
        }
        if part.node.is_constant() {
            self.add_name(&name.ident, "", part.kind, part.node.clone())?;
            return Ok(part.node);
        }
        let slot = self.slots;
        self.slots += 1;
        self.add_name(&name.ident, "", part.kind, Node::Variable(slot))?;
        Ok(Node::Let(slot, Box::new(part.node)))
    }

    /// A type that is written, if a line can have it.
    fn written_type(&self, written: &syn::Type) -> Option<Type> {
        match written {
            syn::Type::Path(path) => {
                let name = self.table_name(path.path.get_ident()?.span().byte_range()).ok()?;
                Type::from_name(&name).filter(|kind| *kind != Type::Attenuation)
            }
            syn::Type::Reference(reference) if reference.mutability.is_none() => {
                Some(Type::Reference(Box::new(self.written_type(&reference.elem)?)))
            }
            _ => None,
        }
    }

    pub(super) fn array(&mut self, array: &ExprArray, expected: Option<&Type>) -> Checked<Part> {
        let range = array.bracket_token.span.join().byte_range();
        let mut item = match expected {
            Some(Type::Array(item, _)) => Some((**item).clone()),
            _ => None,
        };
        let mut nodes = vec![];
        for syntax in &array.elems {
            let part = self.expression(syntax, item.as_ref())?;
            let kind = item.get_or_insert_with(|| part.kind.clone());
            nodes.push(self.demand(part, &kind.clone(), "This array has")?.node);
        }
        let Some(item) = item else { return refuse(range, "An array here has elements.") };
        let kind = Type::Array(Box::new(item), nodes.len());
        self.part(Node::Array(nodes), kind, range)
    }

    pub(super) fn index(&mut self, index: &ExprIndex) -> Checked<Part> {
        let sign = index.bracket_token.span.join().byte_range();
        let base = self.expression(&index.expr, None)?;
        self.refuse_block_before(&index.expr, &base)?;
        let position = self.expression(&index.index, None)?;
        let position = self.demand(position, &Type::Usize, "An index is")?;
        let item = match (self.types.resolve(&base.kind).referent(), &position.node) {
            (Type::Array(_, length), Node::Constant(Value::Usize(at))) if *length as u64 <= *at => {
                return refuse(sign, format!("It has {length} elements; the first is [0]."));
            }
            (Type::Array(item, _), _) => (**item).clone(),
            (Type::DVec3, _) => Type::F64,
            (kind, _) => {
                let kind = self.types.describe(kind);
                return refuse(sign, format!("{kind} has no elements: vectors and arrays have."));
            }
        };
        let range = base.range.start..sign.end;
        self.part(Node::Index(Box::new([base.node, position.node]), sign), item, range)
    }

    pub(super) fn reference(
        &mut self,
        reference: &ExprReference,
        expected: Option<&Type>,
    ) -> Checked<Part> {
        let sign = reference.and_token.span.byte_range();
        if reference.mutability.is_some() {
            return refuse(sign, "References here are without mut.");
        }
        let expected = match expected {
            Some(Type::Reference(inner)) => Some(&**inner),
            _ => None,
        };
        let part = self.expression(&reference.expr, expected)?;
        let range = sign.start..part.range.end;
        Ok(Part { kind: Type::Reference(Box::new(part.kind)), range, ..part })
    }

    /// Refuses a block before an operator where a statement begins: Rust takes it for the whole.
    pub(super) fn refuse_block_before(&self, syntax: &Expr, part: &Part) -> Checked<()> {
        let before = self.text[..part.range.start].trim_end();
        let is_start = before.is_empty() || before.ends_with(['{', '}', ';', '/']);
        if is_start && matches!(syntax, Expr::If(_) | Expr::Block(_)) {
            return refuse(part.range.clone(), "Put parentheses around this block.");
        }
        Ok(())
    }

    /// Refuses syntax that Rust has, and a line here has not.
    pub(super) fn refuse_unsupported<T>(&self, syntax: &Expr) -> Checked<T> {
        let (span, what) = match syntax {
            Expr::Assign(one) => {
                let range = one.eq_token.span.byte_range();
                return refuse(range, "For =, Rust has == to compare.");
            }
            Expr::Closure(closure) => (closure.or1_token.span, "a closure"),
            Expr::Match(one) => (one.match_token.span, "a match"),
            Expr::ForLoop(one) => (one.for_token.span, "a loop"),
            Expr::While(one) => (one.while_token.span, "a loop"),
            Expr::Loop(one) => (one.loop_token.span, "a loop"),
            Expr::Let(one) => (one.let_token.span, "if let"),
            Expr::Tuple(one) => (one.paren_token.span.join(), "a tuple"),
            _ => (Span::call_site(), "this"),
        };
        let range = Some(span.byte_range()).filter(|range| range.end != 0);
        let sentence = format!(
            "A page can't draw with {what}: it knows let, if … else, blocks, arrays, references, \
             numbers, vectors and their methods."
        );
        refuse(range.unwrap_or(0..self.text.len()), sentence)
    }
}
