use crate::expressions::checker::Checker;
use crate::expressions::node::{Node, Stop, spend};
use crate::expressions::refusal::Refusal;
use crate::expressions::scan::{blank_comments, parse_syntax};
use crate::expressions::value::Value;
use course::Place;

/// Meaning of a reader's text: a function of the variables of its place.
pub struct Expression {
    node: Node,
    /// How many values of `let` it has.
    locals: usize,
    /// Steps that it takes at most.
    steps: u64,
    /// Bytes of its text.
    pub(super) length: usize,
}

/// Reads what a reader wrote at a place.
pub fn parse_expression(place: &Place, text: &str) -> Result<Expression, Refusal> {
    let bare = blank_comments(text)?;
    let syntax = parse_syntax(&bare)?;
    let mut checker = Checker::new(place, &bare);
    let node = checker.check_whole(&syntax)?;
    let Checker { locals, steps, .. } = checker;
    Ok(Expression { node, locals, steps, length: text.len() })
}

impl Expression {
    /// Computes its value for these values of the variables.
    pub fn evaluate(&self, variables: &[Value]) -> Result<Value, Stop> {
        spend(self.steps);
        let mut locals = vec![Value::Bool(false); self.locals];
        self.node.evaluate(variables, &mut locals)
    }
}
