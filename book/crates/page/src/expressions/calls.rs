//! Calls of methods and functions.

use crate::expressions::checker::{Checked, Checker, chain_range};
use crate::expressions::functions::FUNCTIONS;
use crate::expressions::node::{Function, Node, Part};
use crate::expressions::refusal::{
    ASSOCIATED, explain_open_number, explain_unknown_function, explain_unknown_member, refuse,
};
use crate::expressions::types::Type;
use crate::expressions::value::Value;
use std::ops::Range;
use syn::punctuated::Punctuated;
use syn::{Expr, ExprCall, ExprMethodCall, Pat, Token};

type Arguments = Punctuated<Expr, Token![,]>;

/// What a step asks of its best hit so far, as `places.txt` has it.
const BEST: [&str; 2] = ["best.is_none()", "best.as_ref().map_or(f64::INFINITY,|hit|hit.t)"];

impl Checker<'_> {
    pub(super) fn method_call(&mut self, call: &ExprMethodCall) -> Checked<Part> {
        let method = call.method.to_string();
        let sign = call.dot_token.span.byte_range().start..call.method.span().byte_range().end;
        let end = call.paren_token.span.join().byte_range().end;
        let receiver_range = chain_range(&call.receiver);
        if receiver_range.is_some_and(|range| &self.text[range] == "best.as_ref()")
            && let Some(part) = self.best_call(&method, &call.args, sign.start..end)?
        {
            return Ok(part);
        }
        let receiver = self.expression(&call.receiver, None)?;
        if call.turbofish.is_some() {
            return refuse(sign, "Leave out the ::<…>.");
        }
        let function = self.find_member(&format!("::{method}"), &receiver, sign.clone())?;
        let range = receiver.range.start..end;
        self.call_with(function, vec![receiver], &call.args, sign, range)
    }

    /// The field `.NAME` or the method `::NAME` of a value.
    pub(super) fn find_member(
        &self,
        member: &str,
        part: &Part,
        sign: Range<usize>,
    ) -> Checked<&'static Function> {
        let kind = self.types.resolve(&part.kind);
        if let Type::Open(_) = kind.referent() {
            let sentence = explain_open_number(&self.text[part.range.clone()]);
            return refuse(part.range.clone(), sentence);
        }
        let name = format!("{}{member}", kind.referent().name().unwrap_or_default());
        let is_associated = ASSOCIATED.contains(&member.trim_start_matches(':'));
        let function = FUNCTIONS.iter().find(|one| one.name == name && !is_associated);
        match function {
            Some(function) => Ok(function),
            None => refuse(sign, explain_unknown_member(&self.types, member, &kind)),
        }
    }

    /// A call such as `f64::max(a, b)`.
    pub(super) fn function_call(&mut self, call: &ExprCall) -> Checked<Part> {
        let sign = chain_range(&call.func).unwrap_or(0..self.text.len());
        let range = sign.start..call.paren_token.span.join().byte_range().end;
        let name = self.table_name(sign.clone())?;
        let rows = FUNCTIONS.iter().filter(|one| one.name == name && name.contains("::"));
        let rows: Vec<_> = rows.filter(|one| !one.takes.is_empty()).collect();
        match (&rows[..], call.args.first()) {
            // There is one for each type.
            ([_, _, ..], Some(argument)) if call.args.len() == 1 => {
                let part = self.expression(argument, None)?;
                match self.find_function(&name, std::slice::from_ref(&part.kind)) {
                    Some(function) => self.call(function, vec![part], sign, range),
                    None => {
                        let kind = self.types.describe(&part.kind);
                        refuse(part.range, format!("{name} doesn't take {kind}."))
                    }
                }
            }
            ([function, ..], _) => self.call_with(function, vec![], &call.args, sign, range),
            ([], first) => {
                let first = first.and_then(chain_range).map_or("a", |range| &self.text[range]);
                match explain_unknown_function(&name, first, call.args.len()) {
                    Some(sentence) => refuse(sign, sentence),
                    None => self.refuse_unknown(sign),
                }
            }
        }
    }

    /// The call of a function with these values in its parentheses.
    fn call_with(
        &mut self,
        function: &'static Function,
        mut parts: Vec<Part>,
        arguments: &Arguments,
        sign: Range<usize>,
        range: Range<usize>,
    ) -> Checked<Part> {
        let takes = &function.takes[parts.len()..];
        let subject = format!("{} takes", &self.text[sign.clone()]);
        if takes.len() != arguments.len() {
            let (wanted, count) = (takes.len(), arguments.len());
            return refuse(sign, format!("{subject} {wanted} in its parentheses, not {count}."));
        }
        for (argument, wanted) in arguments.iter().zip(takes) {
            parts.push(self.value(argument, wanted, &subject)?);
        }
        self.call(function, parts, sign, range)
    }

    /// What a line asks of the best hit so far, of which the page knows its t.
    fn best_call(
        &mut self,
        method: &str,
        arguments: &Arguments,
        range: Range<usize>,
    ) -> Checked<Option<Part>> {
        let node =
            |text| self.names.iter().find(|one| one.text == text).map(|one| one.node.clone());
        let [Some(is_none), Some(t)] = BEST.map(node) else { return Ok(None) };
        let arguments: Vec<_> = arguments.iter().collect();
        let truth = |truth| (Node::Constant(Value::Bool(truth)), Type::Bool);
        let ((default, kind), closure) = match (method, &arguments[..]) {
            ("is_none_or", [Expr::Closure(closure)]) => (truth(true), closure),
            ("is_some_and", [Expr::Closure(closure)]) => (truth(false), closure),
            ("map_or", [default, Expr::Closure(closure)]) => {
                let default = self.expression(default, None)?;
                ((default.node, default.kind), closure)
            }
            _ => return Ok(None),
        };
        let Some(Pat::Ident(hit)) = closure.inputs.first() else { return Ok(None) };
        self.add_name(&hit.ident, ".t", Type::F64, t)?;
        let body = self.expression(&closure.body, None);
        self.names.pop();
        let body = self.demand(body?, &kind, "As before the comma, this is")?;
        // Both are evaluated, though one is needed: as in Rust.
        self.slots += 1;
        let slot = self.slots - 1;
        let choice = Node::If(Box::new([is_none, Node::Variable(slot), body.node]));
        let nodes = vec![Node::Let(slot, Box::new(default)), choice];
        self.part(Node::Block(nodes), kind, range).map(Some)
    }
}
