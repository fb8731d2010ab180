//! Compiles `if` and `let`, which do more than call a function of their operands.

use crate::expressions::compiler::Compiler;
use crate::expressions::evaluation::Run;
use crate::expressions::operation::range_of;
use crate::expressions::part::Part;
use crate::expressions::refusal::{Fault, Refusal, refuse};
use crate::expressions::refused_call::explain_mismatch;
use crate::expressions::value::Value;
use course::ValueType;
use std::ops::Range;
use std::rc::Rc;
use syn::{ExprIf, Ident, LocalInit, Pat, PatIdent, Stmt};

impl Compiler<'_> {
    /// Compiles an `if`.
    pub fn compile_if(&mut self, branches: &ExprIf) -> Result<Part, Refusal> {
        let Some((_, other)) = &branches.else_branch else {
            return refuse(range_of(&branches.if_token), Fault::MissingElse);
        };
        let condition = self.compile_expression(&branches.cond)?;
        let then = &branches.then_branch;
        let then = self.compile_statements(&then.stmts, range_of(then))?;
        let other = self.compile_expression(other)?;
        for (part, wanted) in [(&condition, ValueType::Bool), (&other, then.value_type)] {
            if part.value_type != wanted {
                let fault = explain_mismatch("if takes", part, self.text, wanted);
                return refuse(part.range.clone(), fault);
            }
        }
        let (value_type, is_open) = (then.value_type, then.is_open && other.is_open);
        let run = match condition.constant_value() {
            Some(Value::Bool(true)) => then.run,
            Some(_) => other.run,
            None => {
                let (condition, then, other) = (condition.run, then.run, other.run);
                Run::Call(Rc::new(move |evaluation| {
                    evaluation.spend(1)?;
                    match condition.evaluate(evaluation)? {
                        Value::Bool(true) => then.evaluate(evaluation),
                        _ => other.evaluate(evaluation),
                    }
                }))
            }
        };
        Ok(Part { run, value_type, is_open, range: 0..0 })
    }

    /// Compiles the remaining statements of the block at `range`. Their value is that of the last
    /// one.
    pub fn compile_statements(
        &mut self,
        statements: &[Stmt],
        range: Range<usize>,
    ) -> Result<Part, Refusal> {
        let (local, rest) = match statements {
            [Stmt::Expr(value, None)] => return self.compile_expression(value),
            [Stmt::Local(local), rest @ ..] => (local, rest),
            _ => return refuse(range, Fault::Block),
        };
        let (
            Pat::Ident(PatIdent { ident, by_ref: None, subpat: None, .. }),
            Some(LocalInit { expr, diverge: None, .. }),
        ) = (&local.pat, &local.init)
        else {
            return refuse(range, Fault::Block);
        };
        let value = self.compile_expression(expr)?;
        let is_constant = value.constant_value().is_some();
        let named_part = match is_constant {
            true => value.clone(),
            false => self.new_slot(value.value_type, value.is_open),
        };
        self.add_name(ident, named_part)?;
        let part = self.compile_statements(rest, range)?;
        self.names.pop();
        if is_constant {
            return Ok(part);
        }
        let (value, rest) = (value.run, part.run);
        let run = Run::Call(Rc::new(move |evaluation| {
            let value = value.evaluate(evaluation)?;
            evaluation.slots.push(value);
            let result = rest.evaluate(evaluation);
            evaluation.slots.pop();
            result
        }));
        Ok(Part { run, ..part })
    }

    /// Adds a name that `let` gives to a part. Refuses a name that is taken, reserved or
    /// capitalised.
    fn add_name(&mut self, ident: &Ident, part: Part) -> Result<(), Refusal> {
        let name = ident.to_string();
        let is_end = |sign: char| !sign.is_alphanumeric() && sign != '_';
        let mut firsts = self.names.iter().map(|(known, _)| known.split(is_end).next());
        if firsts.any(|first| first == Some(&name))
            || ["self", "gen"].contains(&&*name)
            || name.starts_with(char::is_uppercase)
        {
            return refuse(range_of(ident), Fault::Name);
        }
        self.names.push((name, part));
        Ok(())
    }
}
