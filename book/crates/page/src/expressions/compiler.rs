use crate::expressions::expression::{Expression, Part, Run, literal_part};
use crate::expressions::functions::{Apply, find_function};
use crate::expressions::operation::{range_of, split_operation, write_tokens};
use crate::expressions::refusal::{Checked, refuse};
use crate::expressions::refused_call::{explain_mismatch, explain_refused_call};
use crate::expressions::syntax::parse_syntax;
use crate::expressions::value::Value::{self, Bool, Stop, Unfit};
use course::Place;
use std::ops::Range;
use std::sync::Arc;
use syn::{BinOp, Expr, ExprBinary};

/// Places whose value has a method called later, so that it can't be a number of an open type.
const PLACES_WITH_METHODS: [&str; 1] = ["discriminant"];

const STOP: &str = "Here your program would stop: there is no result, or none that fits its type.";

/// Files without `use glam::DVec3`.
const FILES_WITHOUT_VECTORS: [&str; 2] =
    ["step02_sphere/src/quadratic.rs", "step03_nearest/src/nearest.rs"];

/// Compiles the syntax of a text, as far as Rust would.
pub struct Compiler<'a> {
    place: &'a Place,
    text: &'a str,
    /// Names of values: variables of the place, such as `ray.start`, and those of `let`.
    pub names: Vec<(String, Part)>,
    steps: i64,
}

/// Reads what a reader wrote at a place.
pub fn parse_expression(place: &Place, text: &str) -> Checked<Expression> {
    let syntax = parse_syntax(text)?;
    let mut compiler = Compiler { place, text, names: vec![], steps: 0 };
    let sample_of = |kind| Value::from_type(kind).unwrap_or(Unfit);
    for (name, kind) in &place.variables {
        let part = compiler.new_slot(sample_of(kind), false);
        compiler.names.push((name.split_whitespace().collect(), part));
    }
    let part = compiler.expression(&syntax)?;
    let is_block = matches!(syntax, Expr::If(_) | Expr::Block(_));
    let tokens = write_tokens(&syntax);
    let is_or = matches!(syntax, Expr::Binary(ExprBinary { op: BinOp::Or(_), .. }));
    let wanted = sample_of(place.kind);
    let sentence = if !is_block && ["{", "if"].iter().any(|sign| tokens.starts_with(sign)) {
        "Put parentheses around the block at the beginning.".to_owned()
    } else if is_or && place.name == "nearer" {
        "It stands behind a &&: put parentheses around it.".to_owned()
    } else if part.is_open && PLACES_WITH_METHODS.contains(&place.name) {
        "Rust can't tell yet which kind of number this is: write _f64 behind it.".to_owned()
    } else if !part.sample.is_like(&wanted) {
        explain_mismatch("Here belongs", &part, text, &wanted)
    } else {
        let (place, run) = (place.clone(), part.run);
        return Ok(Expression { place, run, steps: compiler.steps });
    };
    refuse(part.range, sentence)
}

impl Compiler<'_> {
    /// Compiles a part of the text. What is the same at each pixel is evaluated here.
    pub fn expression(&mut self, syntax: &Expr) -> Checked<Part> {
        let name = write_tokens(syntax);
        let known = self.names.iter().find(|(known, _)| *known == name);
        let part = known.map(|(_, part)| part.clone()).map_or_else(|| self.compile(syntax), Ok)?;
        let part = Part { range: range_of(syntax), ..part };
        if !part.is_constant {
            return Ok(part);
        }
        let sample = (part.run)(&mut vec![])?;
        Ok(Part { range: part.range, ..Part::constant(sample, part.is_open) })
    }

    /// Compiles syntax that isn't the name of a value.
    fn compile(&mut self, syntax: &Expr) -> Checked<Part> {
        match syntax {
            Expr::Lit(literal) => return literal_part(&literal.lit),
            Expr::Paren(paren) => return self.expression(&paren.expr),
            Expr::Block(block) => return self.statements(&block.block.stmts, range_of(block)),
            Expr::If(branches) => return self.branches(branches),
            _ => {}
        }
        let (name, operands, sign) = split_operation(syntax)?;
        let parts = operands.into_iter().map(|operand| self.expression(operand));
        let parts = parts.collect::<Checked<Vec<_>>>()?;
        let is_member = matches!(syntax, Expr::Field(_) | Expr::MethodCall(_));
        let Some(receiver) = parts.first().filter(|_| is_member) else {
            if name.starts_with("DVec3") && FILES_WITHOUT_VECTORS.contains(&self.place.file) {
                return refuse(sign, "This file has no use glam::DVec3.");
            }
            return self.call(&name, parts, sign);
        };
        if receiver.is_open {
            let sentence =
                "Rust can't tell yet which kind of number this is: write 2.0_f64 for 2.0.";
            return refuse(receiver.range.clone(), sentence);
        }
        self.call(&(receiver.sample.describe().0.to_owned() + &name), parts, sign)
    }

    /// The next value of a variable or of `let`, which differs from pixel to pixel.
    pub fn new_slot(&self, sample: Value, is_open: bool) -> Part {
        let slot = self.names.iter().filter(|(_, part)| !part.is_constant).count();
        let run = move |slots: &mut Vec<Value>| Ok(slots[slot]);
        Part { run: Arc::new(run), is_constant: false, sample, is_open, range: 0..0 }
    }

    /// The call of a function, an operator or a cast, whose name is at `sign`.
    pub fn call(&mut self, name: &str, parts: Vec<Part>, sign: Range<usize>) -> Checked<Part> {
        let values: Vec<_> = parts.iter().map(|part| part.sample).collect();
        let Some(apply) = find_function(name, &values) else {
            return Err(explain_refused_call(name, sign, &parts, self.place, self.text));
        };
        let sample = match (apply(&values), parts.last()) {
            // Rust refuses to divide by a 0 that it knows, whatever is divided.
            (Stop, Some(Part { is_constant: true, .. })) if ["/", "%"].contains(&name) => {
                return refuse(sign, STOP);
            }
            // Where it stops, it would give what its first value is.
            (Stop, _) => values[0],
            (sample, _) => sample,
        };
        self.steps += 1;
        let operands = if name == "if" { &parts[1..] } else { &parts[..] };
        let is_operator = name == "if" || !name.contains(char::is_alphabetic);
        let is_open = is_operator && operands.iter().all(|part| part.is_open);
        let is_constant = parts.iter().all(|part| part.is_constant);
        let runs: Vec<_> = parts.into_iter().map(|part| part.run).collect();
        let run = join_runs(name, apply, runs, sign);
        Ok(Part { run, is_constant, sample, is_open, range: 0..0 })
    }
}

/// A function of values that these runs compute, the later ones only where Rust would. Where it
/// stops, its name at `sign` is to blame.
fn join_runs(name: &str, apply: Apply, runs: Vec<Run>, sign: Range<usize>) -> Run {
    match name {
        "if" | "&&" => Arc::new(move |slots| match runs[0](slots)? {
            Bool(true) => runs[1](slots),
            no => runs.get(2).map_or(Ok(no), |other| other(slots)),
        }),
        "||" => Arc::new(move |slots| match runs[0](slots)? {
            Bool(false) => runs[1](slots),
            yes => Ok(yes),
        }),
        _ => Arc::new(move |slots| {
            let mut values = [Unfit; 3];
            for (value, run) in values.iter_mut().zip(&runs) {
                *value = run(slots)?;
            }
            match apply(&values[..runs.len()]) {
                Stop => refuse(sign.clone(), STOP),
                value => Ok(value),
            }
        }),
    }
}
