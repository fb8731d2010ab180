//! Compiles `if` and `let`, which can't be compiled as calls of functions.

use crate::expressions::compiler::Compiler;
use crate::expressions::evaluation::Computation;
use crate::expressions::operation::{range_of, write_without_spaces};
use crate::expressions::part::{Code, Part};
use crate::expressions::refusal::{Fault, Refusal, refuse};
use crate::expressions::refused_call::explain_mismatch;
use crate::expressions::value::Value;
use course::ValueType;
use quote::ToTokens;
use std::ops::Range;
use std::rc::Rc;
use syn::{BinOp, Expr, ExprAssign, ExprIf, Ident, LocalInit, Pat, PatIdent, Stmt, Type};

/// Whether an operator is a compound assignment such as +=.
pub fn is_compound_assignment(operator: &BinOp) -> bool {
    let sign = write_without_spaces(operator);
    sign.ends_with('=') && !["==", "!=", "<=", ">="].contains(&&*sign)
}

/// Returns the innermost tail expression of a block, or of the first branch of an `if`. An
/// expression without a tail expression is returned unchanged.
fn tail_expression(syntax: &Expr) -> &Expr {
    let statements = match syntax {
        Expr::Block(block) => &block.block.stmts,
        Expr::If(branches) => &branches.then_branch.stmts,
        _ => return syntax,
    };
    match statements.last() {
        Some(Stmt::Expr(value, None)) => tail_expression(value),
        _ => syntax,
    }
}

impl Compiler<'_> {
    /// Compiles an `if`.
    pub fn compile_if(&mut self, branches: &ExprIf) -> Result<Code, Refusal> {
        let Some((_, else_expression)) = &branches.else_branch else {
            return refuse(range_of(&branches.if_token), Fault::MissingElse);
        };
        if let Expr::Assign(assignment) = &*branches.cond {
            return refuse(range_of(&assignment.eq_token), Fault::Comparison);
        }
        let condition = self.compile_expression(&branches.cond)?;
        let then_block = &branches.then_branch;
        let then_part = self.compile_statements(&then_block.stmts, range_of(then_block))?;
        let else_part = Part {
            range: range_of(tail_expression(else_expression)),
            ..self.compile_expression(else_expression)?
        };
        for (part, wanted) in
            [(&condition, ValueType::Bool), (&else_part, then_part.code.value_type)]
        {
            if part.code.value_type != wanted {
                let fault = explain_mismatch("if takes", part, self.text, wanted);
                return refuse(part.range.clone(), fault);
            }
        }
        let has_ambiguous_type =
            then_part.code.has_ambiguous_type && else_part.code.has_ambiguous_type;
        let [if_true, if_false] = [then_part.code.computation, else_part.code.computation];
        let computation = match condition.code.computation {
            Computation::Constant(Value::Bool(true)) => if_true,
            Computation::Constant(_) => if_false,
            condition => Computation::Closure(Rc::new(move |evaluation| {
                evaluation.spend(1)?;
                match condition.evaluate(evaluation)? {
                    Value::Bool(true) => if_true.evaluate(evaluation),
                    _ => if_false.evaluate(evaluation),
                }
            })),
        };
        Ok(Code { computation, value_type: then_part.code.value_type, has_ambiguous_type })
    }

    /// Compiles the remaining statements of the block at `range`. The value of the last statement
    /// is the value of the block.
    pub fn compile_statements(
        &mut self,
        statements: &[Stmt],
        range: Range<usize>,
    ) -> Result<Part, Refusal> {
        let (local, remaining_statements) = match statements {
            [Stmt::Expr(value, None)] => return self.compile_expression(value),
            [Stmt::Local(local), remaining_statements @ ..] => (local, remaining_statements),
            [] => return refuse(range, Fault::BlockWithoutValue),
            [Stmt::Expr(Expr::Assign(assignment), _), ..] => {
                return refuse(range_of(&assignment.eq_token), Fault::Reassignment);
            }
            [Stmt::Expr(Expr::Binary(binary), _), ..] if is_compound_assignment(&binary.op) => {
                return refuse(range_of(&binary.op), Fault::Reassignment);
            }
            [Stmt::Expr(_, Some(semicolon))] => {
                return refuse(range_of(semicolon), Fault::Semicolon);
            }
            _ => return refuse(range, Fault::Block),
        };
        let (pattern, type_name) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(&*typed.ty)),
            pattern => (pattern, None),
        };
        let (
            Pat::Ident(PatIdent { ident, by_ref: None, subpat: None, .. }),
            Some(LocalInit { expr, diverge: None, .. }),
        ) = (pattern, &local.init)
        else {
            return refuse(range, Fault::Block);
        };
        let part = self.compile_expression(expr)?;
        if let Some(type_name) = type_name {
            self.check_type(ident, type_name, &part)?;
        }
        let has_ambiguous_type = part.code.has_ambiguous_type && type_name.is_none();
        let value = Code { has_ambiguous_type, ..part.code };
        let is_constant = value.constant_value().is_some();
        let named_value = match is_constant {
            true => value.clone(),
            false => self.code_of_free_slot(value.value_type, value.has_ambiguous_type),
        };
        self.add_name(ident, named_value)?;
        let Part { code, range } = self.compile_statements(remaining_statements, range)?;
        self.names.pop();
        if is_constant {
            return Ok(Part { code, range });
        }
        let (value, remaining_block) = (value.computation, code.computation);
        let computation = Computation::Closure(Rc::new(move |evaluation| {
            let value = value.evaluate(evaluation)?;
            evaluation.slots.push(value);
            let result = remaining_block.evaluate(evaluation);
            evaluation.slots.pop();
            result
        }));
        Ok(Part { code: Code { computation, ..code }, range })
    }

    /// Checks that the type in a `let` is known, and that the value has this type.
    fn check_type(&self, ident: &Ident, type_name: &Type, value: &Part) -> Result<(), Refusal> {
        let name = type_name.to_token_stream().to_string().replace(' ', "").replace(';', "; ");
        let Some(wanted) = ValueType::from_name(&name) else {
            return refuse(range_of(type_name), Fault::TypeName);
        };
        if wanted == ValueType::Vector && !self.place.has_vectors {
            return refuse(range_of(type_name), Fault::NoVectors);
        }
        if value.code.value_type != wanted {
            let subject = format!("{ident} has to be");
            let fault = explain_mismatch(&subject, value, self.text, wanted);
            return refuse(value.range.clone(), fault);
        }
        Ok(())
    }

    /// Refuses an assignment, which has no value.
    pub fn refuse_assignment(&mut self, assignment: &ExprAssign) -> Refusal {
        let value = match self.compile_expression(&assignment.right) {
            Ok(value) => value,
            Err(refusal) => return refusal,
        };
        let range = range_of(assignment);
        let sign = range_of(&assignment.eq_token);
        if self.place.value_type == ValueType::Bool {
            return Refusal { range: sign, fault: Fault::Comparison };
        }
        let [left, right] = [&assignment.left, &assignment.right].map(range_of);
        let right_text = &self.text[right];
        // The cure for v.x = 1.0, for example, is v.with_x(1.0).
        let with_field = match (&*assignment.left, self.place.value_type) {
            (Expr::Field(field), ValueType::Vector) => {
                let base = self.compile_expression(&field.base).ok();
                let is_vector = base.is_some_and(|base| base.code.value_type == ValueType::Vector);
                let is_number = value.code.value_type == ValueType::F64;
                let name = write_without_spaces(&field.member);
                let is_field = ["x", "y", "z"].contains(&&*name);
                let base = &self.text[range_of(&field.base)];
                (is_vector && is_number && is_field)
                    .then(|| format!("{base}.with_{name}({right_text})"))
            }
            _ => None,
        };
        let cure = with_field.unwrap_or_else(|| right_text.to_owned());
        let left = self.text[left].to_owned();
        Refusal { range, fault: Fault::Assignment { left, cure } }
    }

    /// Adds the name and the value that a `let` binds. Refuses a name that is taken, reserved or
    /// capitalised.
    fn add_name(&mut self, ident: &Ident, value: Code) -> Result<(), Refusal> {
        let name = ident.to_string();
        let is_end = |c: char| !c.is_alphanumeric() && c != '_';
        let mut root_names =
            self.names.iter().map(|(known_name, _)| known_name.split(is_end).next());
        if ["self", "gen"].contains(&&*name) || name.starts_with(char::is_uppercase) {
            return refuse(range_of(ident), Fault::Name);
        }
        if root_names.any(|root_name| root_name == Some(&name)) {
            return refuse(range_of(ident), Fault::TakenName(name));
        }
        self.names.push((name, value));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compound_assignments_are_told_from_other_operators() {
        let is_compound_assignment =
            |sign| is_compound_assignment(&syn::parse_str(sign).expect(sign));
        for sign in ["+=", "%=", "<<="] {
            assert!(is_compound_assignment(sign), "{sign}");
        }
        for sign in ["+", "==", "!=", "<=", ">=", "<"] {
            assert!(!is_compound_assignment(sign), "{sign}");
        }
    }
}
