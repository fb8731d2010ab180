//! Compiles a line. Refuses a line that Rust would refuse.

use crate::expressions::evaluation::{CompiledLine, Computation, Interruption};
use crate::expressions::functions::{Function, find_function, remainder_operations};
use crate::expressions::operation::{
    Operation, OperationKind, range_of, split_operation, write_without_spaces,
};
use crate::expressions::part::{Code, Part, compile_literal};
use crate::expressions::refusal::{Fault, Refusal, refuse};
use crate::expressions::refused_call::{Call, explain_mismatch};
use crate::expressions::syntax::parse_syntax;
use crate::expressions::value::Value;
use course::{Place, PlaceNote, ValueType};
use std::ops::Range;
use std::rc::Rc;
use syn::{BinOp, Expr, ExprBinary, Stmt};

/// Compiles the syntax of a line recursively.
pub struct Compiler<'a> {
    pub place: &'a Place,
    pub text: &'a str,
    /// The variables in scope, each with its name and the code for its value. The place's
    /// variables, such as `ray.start`, come before those that `let` binds.
    pub names: Vec<(String, Code)>,
}

/// Compiles what the reader wrote at a place.
pub fn compile_line(place: &Place, text: &str) -> Result<CompiledLine, Refusal> {
    let statements = parse_syntax(place, text)?;
    let mut compiler = Compiler { place, text, names: vec![] };
    for (name, value_type) in &place.variables {
        let code = compiler.code_of_free_slot(*value_type, false);
        compiler.names.push((name.split_whitespace().collect(), code));
    }
    let part = compiler.compile_statements(&statements, 0..text.len())?;
    if let Some(fault) = explain_why_line_does_not_fit(place, text, &statements, &part) {
        return refuse(part.range, fault);
    }
    Ok(CompiledLine {
        place_index: place.index,
        place_name: place.name,
        step: place.step(),
        length: text.len(),
        computation: part.code.computation,
    })
}

/// Explains why a line that is valid on its own doesn't fit its place. Returns None if the line
/// fits.
fn explain_why_line_does_not_fit(
    place: &Place,
    text: &str,
    statements: &[Stmt],
    part: &Part,
) -> Option<Fault> {
    let has_note = |note| place.notes.contains(&note);
    let [.., Stmt::Expr(syntax, None)] = statements else { return Some(Fault::Block) };
    let is_block = matches!(syntax, Expr::If(_) | Expr::Block(_));
    let tokens = write_without_spaces(syntax);
    let is_or = matches!(syntax, Expr::Binary(ExprBinary { op: BinOp::Or(_), .. }));
    if !is_block && ["{", "if"].iter().any(|start| tokens.starts_with(start)) {
        Some(Fault::BlockAtStart)
    } else if is_or && has_note(PlaceNote::AfterAnd) {
        Some(Fault::OrAfterAnd)
    } else if part.code.has_ambiguous_type && has_note(PlaceNote::MethodFollows) {
        Some(Fault::UntypedValue)
    } else if part.code.value_type != place.value_type {
        Some(explain_mismatch("This has to be", part, text, place.value_type))
    } else {
        None
    }
}

impl Compiler<'_> {
    /// Compiles an expression: the whole line or a part of it.
    pub fn compile_expression(&mut self, syntax: &Expr) -> Result<Part, Refusal> {
        let name = write_without_spaces(syntax);
        let code = match self.names.iter().find(|(known_name, _)| *known_name == name) {
            Some((_, code)) => code.clone(),
            None => self.compile_unnamed_expression(syntax)?,
        };
        Ok(Part { code, range: range_of(syntax) })
    }

    /// Compiles an expression that isn't just the name of a variable.
    fn compile_unnamed_expression(&mut self, syntax: &Expr) -> Result<Code, Refusal> {
        match syntax {
            Expr::Lit(literal) => return compile_literal(&literal.lit),
            Expr::Paren(paren) => return Ok(self.compile_expression(&paren.expr)?.code),
            Expr::Block(block) => {
                return Ok(self.compile_statements(&block.block.stmts, range_of(block))?.code);
            }
            Expr::If(branches) => return self.compile_if(branches),
            Expr::Call(call) if call.args.is_empty() => {
                let name = write_without_spaces(&call.func);
                let name_range = range_of(&call.func);
                let kind = OperationKind::Path;
                let call = Call { syntax, kind, name: &name, name_range, operands: &[] };
                return Err(self.explain_refused_call(&call));
            }
            Expr::Assign(assignment) => return Err(self.refuse_assignment(assignment)),
            _ => {}
        }
        let unknown = self.refuse_unknown_chain(syntax);
        if let Some(refusal) =
            unknown.or_else(|| self.refuse_unknown_function_with_unknown_argument(syntax))
        {
            return Err(refusal);
        }
        let Operation { kind, name, operands, name_range } = split_operation(syntax)?;
        let parts: Vec<_> = operands
            .into_iter()
            .map(|operand| self.compile_expression(operand))
            .collect::<Result<_, _>>()?;
        let receiver = parts.first().filter(|_| kind.is_member());
        let is_into = kind == OperationKind::Method && name == "into";
        if let Some(receiver) =
            receiver.filter(|receiver| receiver.code.has_ambiguous_type && !is_into)
        {
            return Err(self.refuse_ambiguous_type(receiver));
        }
        if kind == OperationKind::Path && name.starts_with("DVec3") && !self.place.has_vectors {
            return refuse(name_range, Fault::NoVectors);
        }
        self.compile_call(&Call { syntax, kind, name: &name, name_range, operands: &parts })
    }

    /// Refuses a receiver such as 2.0, whose type Rust can't infer before looking up the method.
    fn refuse_ambiguous_type(&self, receiver: &Part) -> Refusal {
        let range = receiver.range.clone();
        let literal = &self.text[range.clone()];
        let is_literal = literal.starts_with(|c: char| c.is_ascii_digit());
        let is_literal = is_literal && matches!(syn::parse_str(literal), Ok(Expr::Lit(_)));
        let cure = format!("{literal}_f64");
        let fault =
            if is_literal { Fault::UntypedLiteral { cure } } else { Fault::UntypedReceiver };
        Refusal { range, fault }
    }

    /// Returns code that reads the next free slot. Each of the place's variables has a slot, and so
    /// does each `let` whose value isn't constant.
    pub fn code_of_free_slot(&self, value_type: ValueType, has_ambiguous_type: bool) -> Code {
        let is_slot = |code: &Code| code.constant_value().is_none();
        let slot = self.names.iter().filter(|(_, code)| is_slot(code)).count();
        Code { computation: Computation::Slot(slot), value_type, has_ambiguous_type }
    }

    /// Compiles an operation whose operands are compiled already.
    fn compile_call(&self, call: &Call) -> Result<Code, Refusal> {
        let Call { kind, name, operands, .. } = *call;
        let name_range = call.name_range.clone();
        let types: Vec<_> = operands.iter().map(|operand| operand.code.value_type).collect();
        let Some(function) = find_function(kind, name, &types) else {
            return Err(self.explain_refused_call(call));
        };
        // Rust refuses to divide an integer by a constant 0, even if the dividend isn't constant.
        let divisor = operands.last().and_then(|operand| operand.code.constant_value());
        if ["/", "%"].contains(&name) && divisor == Some(Value::I32(0)) {
            return refuse(name_range, Fault::NoResult);
        }
        let keeps_ambiguous_type =
            matches!(kind, OperationKind::Operator | OperationKind::Array | OperationKind::Index);
        let has_ambiguous_type =
            keeps_ambiguous_type && operands.iter().all(|operand| operand.code.has_ambiguous_type);
        let constants: Option<Vec<_>> =
            operands.iter().map(|operand| operand.code.constant_value()).collect();
        if let Some(values) = constants {
            return match (function.apply)(&values) {
                Some(value) => Ok(Code::constant(value, has_ambiguous_type)),
                None => refuse(name_range, Fault::NoResult),
            };
        }
        let computations: Vec<_> =
            operands.iter().map(|operand| operand.code.computation.clone()).collect();
        let computation = compile_function_call(function, &computations, name_range);
        Ok(Code { computation, value_type: function.result, has_ambiguous_type })
    }
}

/// Makes a computation that calls a function with the results of `computations`.
fn compile_function_call(
    function: &'static Function,
    computations: &[Computation],
    name_range: Range<usize>,
) -> Computation {
    match (function.name, computations) {
        ("&&", [first, second]) => short_circuit(first.clone(), second.clone(), false),
        ("||", [first, second]) => short_circuit(first.clone(), second.clone(), true),
        (_, [a]) => call_with_values(function, [a.clone()], name_range),
        (_, [a, b]) => call_with_values(function, [a.clone(), b.clone()], name_range),
        (_, [a, b, c]) => call_with_values(function, [a.clone(), b.clone(), c.clone()], name_range),
        // This arm is unreachable. A call without operands is constant, so it has been evaluated
        // already. No function has more than three parameters.
        _ => call_with_values(function, [], name_range),
    }
}

/// Makes the computation for `&&` or `||`. If the value of `first` is `decisive`, the result is
/// `decisive`, and `second` isn't evaluated. Otherwise, the result is the value of `second`.
fn short_circuit(first: Computation, second: Computation, decisive: bool) -> Computation {
    Computation::Closure(Rc::new(move |evaluation| {
        evaluation.spend(1)?;
        let value = first.evaluate(evaluation)?;
        if value == Value::Bool(decisive) { Ok(value) } else { second.evaluate(evaluation) }
    }))
}

/// Makes a computation that calls a function of N arguments with the results of `computations`. If
/// the function has no result, the error points to the function's name, at `name_range`.
fn call_with_values<const N: usize>(
    function: &'static Function,
    computations: [Computation; N],
    name_range: Range<usize>,
) -> Computation {
    let apply = function.apply;
    let is_remainder = ["%", "rem_euclid"].contains(&function.name);
    Computation::Closure(Rc::new(move |evaluation| {
        let mut values = [Value::Bool(false); N];
        for (value, computation) in values.iter_mut().zip(&computations) {
            *value = computation.evaluate(evaluation)?;
        }
        evaluation.spend(if is_remainder { remainder_operations(&values) } else { 1 })?;
        apply(&values).ok_or_else(|| Interruption::NoResult(name_range.clone()))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compiles a line at a place of type `value_type`, where `x` is an f64 and `k` is an i32.
    fn compile(value_type: ValueType, text: &str) -> Result<Computation, Fault> {
        let place = Place {
            index: 0,
            name: "",
            file: "step01_rays/src/ray.rs",
            has_vectors: true,
            code: "",
            value_type,
            variables: vec![("x", ValueType::F64), ("k", ValueType::I32)],
            notes: vec![],
        };
        let line = compile_line(&place, text).map_err(|refusal| refusal.fault)?;
        Ok(line.computation)
    }

    /// Evaluates a line with `x` = 0.5 and `k` = 0. Returns None if the reader's program would
    /// panic.
    fn evaluate_with_sample_variables(value_type: ValueType, text: &str) -> Option<Value> {
        let mut evaluation = crate::expressions::evaluation::Evaluation::new(1000);
        let computation = compile(value_type, text).expect("the line compiles");
        evaluation.evaluate(&computation, &[Value::F64(0.5), Value::I32(0)]).ok()
    }

    #[test]
    fn part_with_the_same_value_at_each_pixel_is_a_constant() {
        let is_constant =
            |text| matches!(compile(ValueType::F64, text), Ok(Computation::Constant(_)));
        assert!(is_constant("2.0 * (1.0 + f64::from(3))"));
        assert!(is_constant("{ let y = 2.0_f64; y.sqrt() }"));
        assert!(is_constant("if true { 1.0 } else { x }"));
        assert!(!is_constant("0.0 * x"));
    }

    #[test]
    fn let_takes_the_next_slot_and_gives_it_back() {
        let text = "{ let a = x + x; ({ let b = a * a; b + a }) - { let c = 8.0 * x; c } }";
        assert_eq!(evaluate_with_sample_variables(ValueType::F64, text), Some(Value::F64(-2.0)));
    }

    #[test]
    fn operand_that_is_not_needed_cannot_stop_the_program() {
        for text in [
            "k == 0 || 1 / k > 0",
            "k != 0 && 1 / k > 0",
            "if k == 0 { x < 1.0 } else { 1 / k > 0 }",
        ] {
            assert!(evaluate_with_sample_variables(ValueType::Bool, text).is_some(), "{text}");
        }
        assert_eq!(evaluate_with_sample_variables(ValueType::Bool, "1 / k > 0"), None);
    }

    #[test]
    fn division_by_0_and_constant_overflow_are_refused() {
        assert_eq!(compile(ValueType::I32, "k / 0").err(), Some(Fault::NoResult));
        assert_eq!(compile(ValueType::I32, "2147483647 + 1").err(), Some(Fault::NoResult));
    }
}
