use super::{Node, Op};

/// The expression that a text stands for; `name` knows what has a name.
///
/// An error is the text where it can't be read.
pub(crate) fn parse(
    text: &str,
    name: &dyn Fn(&str) -> Option<Node>,
) -> Result<Node, String> {
    let mut reading = Reading { rest: text.trim(), name };
    let node = reading.sum()?;
    if reading.rest.is_empty() { Ok(node) } else { Err(reading.rest.to_owned()) }
}

/// What is not read yet.
struct Reading<'a> {
    rest: &'a str,
    name: &'a dyn Fn(&str) -> Option<Node>,
}

type Read = Result<Node, String>;

/// The operators of two operands, the weakest first; those of a line bind alike.
const OPERATORS: [&[(&str, Op)]; 4] = [
    &[("<=", Op::LessOrEqual), ("<", Op::Less)],
    &[("+", Op::Add), ("-", Op::Sub)],
    &[("*", Op::Mul), ("/", Op::Div), ("·", Op::Dot)],
    &[("^", Op::Pow)],
];

/// The functions, and what stands around a length.
const FUNCTIONS: [(&str, Op); 10] = [
    ("tan", Op::Tan),
    ("max", Op::Max),
    ("unit", Op::Unit),
    ("floor", Op::Floor),
    ("if", Op::If),
    ("least", Op::Nearest),
    ("of", Op::Chosen),
    ("sum", Op::Sum),
    ("mean", Op::Mean),
    ("√", Op::Sqrt),
];

impl Reading<'_> {
    fn take(&mut self, token: &str) -> bool {
        let rest = self.rest.strip_prefix(token).map(str::trim_start);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn sum(&mut self) -> Read {
        self.binary(0)
    }

    fn binary(&mut self, level: usize) -> Read {
        let Some(operators) = OPERATORS.get(level) else { return self.unary() };
        let mut node = self.binary(level + 1)?;
        while let Some((_, op)) = operators.iter().find(|(sign, _)| self.take(sign))
        {
            node = Node::of(*op, [node, self.binary(level + 1)?]);
        }
        Ok(node)
    }

    fn unary(&mut self) -> Read {
        if self.take("-") {
            return Ok(match self.unary()? {
                Node::Number(number) => Node::Number(-number),
                node => Node::of(Op::Neg, [node]),
            });
        }
        if self.take("√") {
            return Ok(Node::of(Op::Sqrt, [self.unary()?]));
        }
        if self.take("|") {
            let node = self.sum()?;
            return self.then("|", Node::of(Op::Length, [node]));
        }
        if self.take("(") {
            let nodes = self.list()?;
            return Ok(match <[Node; 1]>::try_from(nodes) {
                Ok([node]) => node,
                Err(three) => Node::of(Op::Vector, three),
            });
        }
        self.word()
    }

    /// What stands between parentheses, of which the first is read.
    fn list(&mut self) -> Result<Vec<Node>, String> {
        let mut nodes = vec![self.sum()?];
        while self.take(",") {
            nodes.push(self.sum()?);
        }
        if self.take(")") { Ok(nodes) } else { Err(self.rest.to_owned()) }
    }

    fn then(&mut self, token: &str, node: Node) -> Read {
        if self.take(token) { Ok(node) } else { Err(self.rest.to_owned()) }
    }

    /// A number, a function, or a name, perhaps with one of its parts.
    fn word(&mut self) -> Read {
        let is_end = |c: char| !(c.is_alphanumeric() || "_'.".contains(c));
        let end = self.rest.find(is_end).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        if let Some(number) = decimal(word) {
            return Ok(Node::Number(number));
        }
        let function = FUNCTIONS.iter().find(|(name, _)| *name == word);
        if let Some((_, op)) = function.filter(|_| self.take("(")) {
            return Ok(Node::of(*op, self.list()?));
        }
        if let Some(Node::Name(line)) = (self.name)(word)
            && self.take("(")
        {
            return Ok(Node::of(Op::Call(line), self.list()?));
        }
        let (whole, part) = word.split_once('.').unwrap_or((word, ""));
        let part = ["x", "y", "z"].iter().position(|axis| *axis == part);
        // `x.o` is a number of the scene with a name of its own.
        match ((self.name)(word), (self.name)(whole), part) {
            (Some(node), ..) => Ok(node),
            (None, Some(node), Some(part)) => Ok(Node::of(Op::Part(part), [node])),
            _ => Err(word.to_owned()),
        }
    }
}

/// A number such as `0.25`: an integer over a power of ten, both exact in an f64, so
/// that their quotient is rounded once, as the compiler rounds a literal. (The standard
/// library's tables for longer ones are 12 KB of the page's module.)
fn decimal(word: &str) -> Option<f64> {
    let (whole, part) = word.split_once('.').unwrap_or((word, ""));
    let digits: u32 = format!("{whole}{part}").parse().ok()?;
    let number = f64::from(digits) / 10_f64.powi(part.len() as i32);
    debug_assert_eq!(word.parse(), Ok(number));
    Some(number)
}
