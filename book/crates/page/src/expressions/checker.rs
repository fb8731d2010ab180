use crate::expressions::functions::FUNCTIONS;
use crate::expressions::node::{Node, Part};
use crate::expressions::refusal::{
    NAMES_ARE, Refusal, explain_mismatch, explain_unknown_name, refuse,
};
use crate::expressions::types::Type;
use crate::expressions::value::Value;
use course::Place;
use std::ops::Range;
use syn::{BinOp, Expr, ExprBinary, ExprField, Ident, Member};

/// Files without `use glam::DVec3`.
const FILES_WITHOUT_VECTORS: [&str; 2] =
    ["step02_sphere/src/quadratic.rs", "step03_nearest/src/nearest.rs"];

/// Places whose value has a method called later, so that it can't be a number of an open type.
const PLACES_WITH_METHODS: [&str; 2] = ["discriminant", "cosine"];

/// Compiles the syntax of a text, as far as Rust would.
pub struct Checker<'a> {
    pub text: &'a str,
    /// Names of values: variables of the place, such as `ray.start`, and those of `let`.
    pub names: Vec<(String, Type, Node)>,
    /// How many values of `let` it has.
    pub locals: usize,
    /// How many functions and operators it has.
    pub steps: u64,
    place: &'a Place,
}

pub type Checked<T> = Result<T, Refusal>;

impl<'a> Checker<'a> {
    /// Knows the variables of a place.
    pub fn new(place: &'a Place, text: &'a str) -> Self {
        let names = place.variables.iter().enumerate().map(|(slot, (name, kind))| {
            let kind = Type::from_name(kind).unwrap_or(Type::Unit);
            (without_blanks(name), kind, Node::Variable(slot))
        });
        Self { text, names: names.collect(), locals: 0, steps: 0, place }
    }

    /// Compiles the whole text, whose value is that of the place.
    pub fn check_whole(&mut self, syntax: &Expr) -> Checked<Node> {
        let wanted = Type::from_name(self.place.kind).unwrap_or(Type::Unit);
        let part = self.expression(syntax)?;
        let sentence = match (syntax, &part.kind, self.place.name) {
            (_, Type::OpenF64, name) if PLACES_WITH_METHODS.contains(&name) => {
                "Rust can't tell yet which kind of number this is: write _f64 behind it."
            }
            (Expr::Binary(ExprBinary { op: BinOp::Or(_), .. }), _, "nearer") => {
                "It stands behind a &&: put parentheses around it."
            }
            _ => return Ok(self.demand(part, &wanted, "Here belongs")?.node),
        };
        refuse(part.range, sentence)
    }

    /// Compiles a part of the text.
    pub fn expression(&mut self, syntax: &Expr) -> Checked<Part> {
        if let Some(part) = self.find_name(syntax) {
            return Ok(part);
        }
        match syntax {
            Expr::Lit(literal) => self.literal(&literal.lit),
            Expr::Paren(paren) => {
                let inner = self.expression(&paren.expr)?;
                Ok(Part { range: paren.paren_token.span.join().byte_range(), ..inner })
            }
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Cast(cast) => self.cast(cast),
            Expr::Path(_) => self.constant(syntax),
            Expr::Field(field) => self.field(syntax, field),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::Call(call) => self.function_call(call),
            Expr::Index(index) => self.index(index),
            Expr::Array(array) => self.array(array),
            Expr::Reference(reference) => self.reference(reference),
            Expr::If(branches) => self.branches(branches),
            Expr::Block(block) => self.block(&block.block),
            _ => self.refuse_unsupported(syntax),
        }
    }

    /// The part, if its value is of a type; the subject begins a sentence about it.
    pub fn demand(&self, part: Part, wanted: &Type, subject: &str) -> Checked<Part> {
        if !part.kind.fits(wanted) {
            let sentence = explain_mismatch(subject, &part, self.text, wanted);
            return refuse(part.range, sentence);
        }
        let Node::Constant(Value::Whole(number)) = part.node else {
            return Ok(Part { kind: wanted.clone(), ..part });
        };
        let value = match wanted {
            Type::U32 => number.try_into().ok().map(Value::U32),
            Type::Usize => number.try_into().ok().map(Value::Usize),
            Type::OpenWhole => Some(Value::Whole(number)),
            _ => number.try_into().ok().map(Value::I32),
        };
        let Some(value) = value else {
            let kind = wanted.describe();
            let sentence = format!("That's beyond {kind}. With .0 behind it, it isn't one.");
            return refuse(part.range, sentence);
        };
        Ok(Part { node: Node::Constant(value), kind: wanted.clone(), ..part })
    }

    /// A part. What is the same for each pixel is evaluated here.
    pub fn part(&mut self, node: Node, kind: Type, range: Range<usize>) -> Checked<Part> {
        self.steps += u64::from(matches!(node, Node::Call(..)));
        let node = match node.is_constant() {
            true => {
                Node::Constant(node.evaluate(&[], &mut []).or_else(|(at, why)| refuse(at, why))?)
            }
            false => node,
        };
        Ok(Part { node, kind, range })
    }

    /// The variable that a name, with what follows it, is.
    fn find_name(&self, syntax: &Expr) -> Option<Part> {
        let range = chain_range(syntax)?;
        let text = without_blanks(&self.text[range.clone()]);
        let (_, kind, node) = self.names.iter().rev().find(|(name, ..)| *name == text)?;
        Some(Part { node: node.clone(), kind: kind.clone(), range })
    }

    /// Makes a name known, which `let` or a closure gives to a value.
    pub fn add_name(&mut self, ident: &Ident, suffix: &str, kind: Type, node: Node) -> Checked<()> {
        let name = ident.to_string();
        let mut reserved_names =
            self.place.variables.iter().filter_map(|(one, _)| one.split_once(['.', '(']));
        if reserved_names.any(|(first, _)| first == name)
            || name == "self"
            || name.starts_with(|sign: char| sign.is_ascii_uppercase())
            || !suffix.is_empty() && self.names.iter().any(|one| one.0 == name)
        {
            return refuse(ident.span().byte_range(), "Take another name here, in small letters.");
        }
        self.names.push((name + suffix, kind, node));
        Ok(())
    }

    /// A path as the table of functions has it.
    pub fn table_name(&self, range: Range<usize>) -> Checked<String> {
        let text = without_blanks(&self.text[range.clone()]);
        if text.starts_with("DVec3") && FILES_WITHOUT_VECTORS.contains(&self.place.file) {
            return refuse(range, "This file has no use glam::DVec3: write glam:: before it.");
        }
        Ok(text.trim_start_matches("glam::").to_owned())
    }

    fn constant(&mut self, syntax: &Expr) -> Checked<Part> {
        let range = chain_range(syntax).unwrap_or_default();
        let name = self.table_name(range.clone())?;
        match FUNCTIONS.iter().find(|one| one.name == name && one.takes.is_empty()) {
            Some(_) => self.call(&name, vec![], range.clone(), range),
            None => self.refuse_unknown(range),
        }
    }

    /// Refuses a name that is not known.
    pub fn refuse_unknown<T>(&self, range: Range<usize>) -> Checked<T> {
        let sentence = explain_unknown_name(&self.text[range.clone()], self.place);
        refuse(range, sentence)
    }

    fn field(&mut self, syntax: &Expr, field: &ExprField) -> Checked<Part> {
        let full_range = chain_range(syntax);
        let base = self.expression(&field.base).or_else(|refusal| match full_range {
            // What is not known is named whole, such as `sphere.center`.
            Some(full_range) if refusal.sentence.contains(NAMES_ARE) => {
                self.refuse_unknown(full_range)
            }
            _ => Err(refusal),
        })?;
        let Member::Named(member) = &field.member else {
            return self.refuse_unsupported(syntax);
        };
        let range = field.dot_token.span.byte_range().start..member.span().byte_range().end;
        self.call_member(&format!(".{member}"), base, vec![], range.clone(), range.end)
    }
}

/// The bytes of a name with fields and calls behind it: all that a variable of a place may be.
pub fn chain_range(syntax: &Expr) -> Option<Range<usize>> {
    let (inner, end) = match syntax {
        Expr::Path(path) => {
            let segments = &path.path.segments;
            let (first, last) = (segments.first()?.ident.span(), segments.last()?.ident.span());
            return Some(first.byte_range().start..last.byte_range().end);
        }
        Expr::Field(ExprField { base, member: Member::Named(name), .. }) => (base, name.span()),
        Expr::MethodCall(call) => (&call.receiver, call.paren_token.span.join()),
        Expr::Call(call) => (&call.func, call.paren_token.span.join()),
        _ => return None,
    };
    Some(chain_range(inner)?.start..end.byte_range().end)
}

fn without_blanks(text: &str) -> String {
    text.split_whitespace().collect()
}
