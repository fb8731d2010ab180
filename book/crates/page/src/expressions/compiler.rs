use crate::expressions::functions::find_function;
use crate::expressions::node::{Expression, Node};
use crate::expressions::refusal::{Checked, explain_mismatch, explain_refused_call, refuse};
use crate::expressions::syntax::parse_syntax;
use crate::expressions::value::Value::{self, Stop, Unfit};
use course::Place;
use quote::ToTokens;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::{BinOp, Expr, ExprBinary, Ident};

/// Places whose value has a method called later, so that it can't be a number of an open type.
const PLACES_WITH_METHODS: [&str; 2] = ["discriminant", "cosine"];

/// A compiled part of a text.
#[derive(Clone)]
pub struct Part {
    pub node: Node,
    /// A value of its type: its own, if it is the same at each pixel.
    pub sample: Value,
    /// Whether it is a number such as 2.0, or a sum of such, which has no methods yet.
    pub is_open: bool,
    pub range: Range<usize>,
}

impl Part {
    pub fn new(node: Node, sample: Value, is_open: bool) -> Self {
        Self { node, sample, is_open, range: 0..0 }
    }
}

/// Compiles the syntax of a text, as far as Rust would.
pub struct Compiler<'a> {
    pub place: &'a Place,
    pub text: &'a str,
    /// Names of values: variables of the place, such as `ray.start`, and those of `let`.
    pub names: Vec<(String, Part)>,
    pub slots: usize,
    steps: i64,
}

/// Reads what a reader wrote at a place.
pub fn parse_expression(place: &Place, text: &str) -> Checked<Expression> {
    let syntax = parse_syntax(text)?;
    let mut compiler = Compiler { place, text, names: vec![], slots: 0, steps: 0 };
    let sample_of = |kind| Value::from_type(kind).unwrap_or(Unfit);
    for (name, kind) in &place.variables {
        let part = compiler.new_slot(sample_of(kind), false);
        compiler.names.push((name.split_whitespace().collect(), part));
    }
    let part = compiler.expression(&syntax)?;
    let is_block = matches!(syntax, Expr::If(_) | Expr::Block(_));
    let starts_as_block = ["{", "if"].iter().any(|sign| write_tokens(&syntax).starts_with(sign));
    let sentence = match (&syntax, place.name) {
        _ if starts_as_block && !is_block => "Put parentheses around the block at the beginning.",
        (Expr::Binary(ExprBinary { op: BinOp::Or(_), .. }), "nearer") => {
            "It stands behind a &&: put parentheses around it."
        }
        (_, name) if part.is_open && PLACES_WITH_METHODS.contains(&name) => {
            "Rust can't tell yet which kind of number this is: write _f64 behind it."
        }
        _ => {
            compiler.demand(&part, sample_of(place.kind), "Here belongs")?;
            let Compiler { slots, steps, .. } = compiler;
            let (place, length) = (place.clone(), text.len());
            return Ok(Expression { place, node: part.node, slots, steps, length });
        }
    };
    refuse(part.range, sentence)
}

/// The bytes of a part of the text.
pub fn range_of(syntax: &impl Spanned) -> Range<usize> {
    syntax.span().byte_range()
}

/// A part of the text without blanks and comments.
pub fn write_tokens(syntax: &impl ToTokens) -> String {
    syntax.to_token_stream().to_string().split_whitespace().collect()
}

impl Compiler<'_> {
    /// Compiles a part of the text. What is the same at each pixel is evaluated here.
    pub fn expression(&mut self, syntax: &Expr) -> Checked<Part> {
        let name = match syntax {
            Expr::Path(_) | Expr::Field(_) | Expr::MethodCall(_) | Expr::Call(_) => {
                self.find_name(&write_tokens(syntax))
            }
            _ => None,
        };
        let part = name.map_or_else(|| self.compile(syntax), Ok)?;
        let part = Part { range: range_of(syntax), ..part };
        if !part.node.is_constant() {
            return Ok(part);
        }
        let sample = part.node.evaluate(&mut [])?;
        Ok(Part { node: Node::Constant(sample), sample, ..part })
    }

    /// The value of this name, with what follows it.
    pub fn find_name(&self, text: &str) -> Option<Part> {
        self.names.iter().find(|(name, _)| *name == text).map(|(_, part)| part.clone())
    }

    /// A value that is written while a line is evaluated.
    pub fn new_slot(&mut self, sample: Value, is_open: bool) -> Part {
        self.slots += 1;
        Part::new(Node::Slot(self.slots - 1), sample, is_open)
    }

    /// Makes a name known, which `let` or a closure gives to a value.
    pub fn add_name(&mut self, ident: &Ident, suffix: &str, part: Part) -> Checked<()> {
        let name = ident.to_string();
        let is_end = |sign: char| !sign.is_alphanumeric() && sign != '_';
        let is_known =
            self.names.iter().any(|(known, _)| known.split(is_end).next() == Some(&name));
        if is_known
            || ["self", "gen"].contains(&&*name)
            || name.starts_with(|sign: char| sign.is_uppercase())
        {
            return refuse(range_of(ident), "Take another name here, in small letters.");
        }
        self.names.push((name + suffix, part));
        Ok(())
    }

    /// Refuses a part whose value isn't of a type; the subject begins the sentence about it.
    pub fn demand(&self, part: &Part, wanted: Value, subject: &str) -> Checked<()> {
        if part.sample.is_like(&wanted) {
            return Ok(());
        }
        let sentence = explain_mismatch(subject, part, self.text, &wanted);
        refuse(part.range.clone(), sentence)
    }

    /// The call of a function, an operator or a cast, whose name is at `sign`.
    pub fn call(&mut self, name: &str, parts: Vec<Part>, sign: Range<usize>) -> Checked<Part> {
        let values: Vec<_> = parts.iter().map(|part| part.sample).collect();
        let Some(function) = find_function(name, &values) else {
            return Err(explain_refused_call(name, sign, &parts, self.text));
        };
        let sample = match ((function.apply)(&values), parts.last()) {
            // Rust refuses to divide by a 0 that it knows, whatever is divided.
            (Stop(sentence), Some(Part { node: Node::Constant(_), .. }))
                if ["/", "%"].contains(&name) =>
            {
                return refuse(sign, sentence);
            }
            // Where it stops, it would give what its first value is.
            (Stop(_), _) => values[0],
            (sample, _) => sample,
        };
        self.steps += 1;
        let is_operator = !name.contains(char::is_alphanumeric);
        let is_open = is_operator && parts.iter().all(|part| part.is_open);
        let nodes = parts.into_iter().map(|part| part.node).collect();
        Ok(Part::new(Node::Call(function.apply, nodes, sign), sample, is_open))
    }
}
