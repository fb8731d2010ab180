//! What a line may have besides functions of its parts.

use crate::expressions::compiler::Compiler;
use crate::expressions::expression::Part;
use crate::expressions::operation::range_of;
use crate::expressions::refusal::{Checked, refuse};
use crate::expressions::value::Value;
use std::ops::Range;
use std::sync::Arc;
use syn::{ExprIf, Ident, LocalInit, Pat, PatIdent, Stmt};

const BLOCK: &str = "A block here has let x = …; and a value at its end.";

impl Compiler<'_> {
    /// One of two values.
    pub fn branches(&mut self, branches: &ExprIf) -> Checked<Part> {
        let sign = range_of(&branches.if_token);
        let Some((_, other)) = &branches.else_branch else {
            let sentence = "This if needs an else { … }: what is the value otherwise?";
            return refuse(sign, sentence);
        };
        let condition = self.expression(&branches.cond)?;
        let then = &branches.then_branch;
        let then = self.statements(&then.stmts, range_of(then))?;
        let other = self.expression(other)?;
        self.call("if", vec![condition, then, other], sign)
    }

    /// The value of these statements, the last of a block at this range.
    pub fn statements(&mut self, statements: &[Stmt], range: Range<usize>) -> Checked<Part> {
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
        let named_part = match value.is_constant {
            true => value.clone(),
            false => self.new_slot(value.sample, value.is_open),
        };
        self.add_name(ident, named_part)?;
        let part = self.statements(rest, range)?;
        self.names.pop();
        if value.is_constant {
            return Ok(part);
        }
        let run = move |slots: &mut Vec<Value>| {
            let named_value = (value.run)(slots)?;
            slots.push(named_value);
            let result = (part.run)(slots);
            slots.pop();
            result
        };
        Ok(Part { run: Arc::new(run), is_constant: false, ..part })
    }

    /// Makes a name known, which `let` gives to a value.
    fn add_name(&mut self, ident: &Ident, part: Part) -> Checked<()> {
        let name = ident.to_string();
        let is_end = |sign: char| !sign.is_alphanumeric() && sign != '_';
        let mut firsts = self.names.iter().map(|(known, _)| known.split(is_end).next());
        if firsts.any(|first| first == Some(&name))
            || ["self", "gen"].contains(&&*name)
            || name.starts_with(char::is_uppercase)
        {
            return refuse(range_of(ident), "Take another name here, in small letters.");
        }
        self.names.push((name, part));
        Ok(())
    }
}
