use super::{Node, Op, Tree, Value};
use crate::measure::{number, vector};

impl Tree {
    /// A line as a formula, as the book writes it.
    pub fn told(&self, line: usize, node: &Node, free: Option<&Value>) -> String {
        let name = shown(&self.lines[line].name);
        let argument = if name == "offset" { "k" } else { "d" };
        let text = Print { tree: self, free, argument }.at(node, 0);
        match &*self.lines[line].name {
            "fade" => format!("divisor = {text}"),
            "order" => format!("nearest by {text}"),
            "I'" => format!("seen = {text}"),
            _ => format!("{name} = {text}"),
        }
    }
}

/// A name without the primes that tell it apart.
pub(crate) fn shown(name: &str) -> String {
    name.trim_end_matches('\'').to_owned()
}

struct Print<'a> {
    tree: &'a Tree,
    free: Option<&'a Value>,
    /// The letter for the argument of a line that has one.
    argument: &'static str,
}

impl Print<'_> {
    /// The text of a node whose surroundings bind as strongly as `level` says.
    fn at(&self, node: &Node, level: u8) -> String {
        let Node::Of(op, nodes) = node else {
            return match node {
                Node::Number(x) if x.is_infinite() => "no hit".to_owned(),
                Node::Number(x) if *x == std::f64::consts::PI => "π".to_owned(),
                Node::Number(x) => negative(number(*x), level),
                Node::Name(name) => match &*self.tree.lines[*name].name {
                    "order" => "t".to_owned(),
                    "halfway" => "normalised(l + v)".to_owned(),
                    // In a power it needs parentheses.
                    "cosine" if 5 < level => "(r·v)".to_owned(),
                    "cosine" => "r·v".to_owned(),
                    name => shown(name),
                },
                Node::Free(_) => match self.free {
                    Some(v) if v.is_vector() => vector(v.vector(0)),
                    Some(v) => negative(number(v.scalar(0)), level),
                    None => "?".to_owned(),
                },
                _ => self.argument.to_owned(),
            };
        };
        let (text, own) = self.operation(*op, nodes);
        if own < level { format!("({text})") } else { text }
    }

    /// The text of an operation, and how strongly it binds: 1 a condition, 2 a sum, 3 a
    /// minus, 4 a product, 5 a power, 9 what needs no parentheses.
    fn operation(&self, op: Op, nodes: &[Node]) -> (String, u8) {
        let at = |k: usize, level: u8| self.at(&nodes[k], level);
        let call = |name: &str| {
            let all: Vec<_> = (0..nodes.len()).map(|k| at(k, 0)).collect();
            (format!("{name}({})", all.join(", ")), 9)
        };
        match op {
            Op::Add => match at(1, 4).strip_prefix("(−") {
                Some(less) if matches!(nodes[1], Node::Number(_)) => {
                    (format!("{} − {}", at(0, 2), less.trim_end_matches(')')), 2)
                }
                _ => (format!("{} + {}", at(0, 2), at(1, 4)), 2),
            },
            Op::Sub => (format!("{} − {}", at(0, 2), at(1, 4)), 2),
            Op::Mul => (self.product(&nodes[0], &nodes[1]), 4),
            Op::Div => (format!("{} / {}", at(0, 4), at(1, 5)), 4),
            Op::Dot => (format!("{}·{}", at(0, 5), at(1, 5)), 5),
            Op::Cross => (format!("{} × {}", at(0, 5), at(1, 5)), 4),
            Op::Pow if nodes[1] == Node::Number(2.0) => {
                (format!("{}²", at(0, 6)), 5)
            }
            Op::Pow => (format!("{}^{}", at(0, 6), at(1, 6)), 5),
            Op::Neg => (format!("−{}", at(0, 4)), 3),
            Op::Sqrt => (format!("√{}", at(0, 6)), 5),
            Op::Length | Op::Abs => (format!("|{}|", at(0, 0)), 9),
            Op::Less => (format!("{} < {}", at(0, 2), at(1, 2)), 1),
            Op::LessOrEqual => (format!("{} ≤ {}", at(0, 2), at(1, 2)), 1),
            Op::If => {
                (format!("{} if {}, else {}", at(1, 2), at(0, 1), at(2, 0)), 0)
            }
            Op::Vector => call(""),
            Op::Part(axis) => {
                (format!("{}_{}", at(0, 9), ["x", "y", "z"][axis]), 9)
            }
            Op::Max => call("max"),
            Op::Min => call("min"),
            Op::Unit => call("normalised"),
            Op::Tan => call("tan"),
            Op::Atan => call("atan"),
            Op::Sin => call("sin"),
            Op::Cos => call("cos"),
            Op::Acos => call("acos"),
            Op::Floor => call("floor"),
            Op::Ceil => call("ceil"),
            Op::Call(line) if &*self.tree.lines[line].name == "fade" => {
                (self.fade(&nodes[0]), 9)
            }
            Op::Call(line) => call(&self.tree.lines[line].name),
            Op::Sum => (format!("the sum of {} over all lights", at(0, 9)), 2),
            Op::Product => {
                (format!("the product of {} over all lights", at(0, 9)), 2)
            }
            Op::Most => (format!("the largest {} of all lights", at(0, 9)), 2),
            Op::Alone(0) => (format!("{} of the first alone", at(0, 9)), 2),
            Op::Alone(_) => (format!("{} of the last alone", at(0, 9)), 2),
            Op::Nearest if nodes[1] == Node::Number(0.0) => {
                (format!("that of the least {}", at(0, 9)), 2)
            }
            Op::Nearest => {
                let t = at(0, 9);
                let far = format!("{t} < {t} so far + {}", at(1, 3));
                (format!("that of the last with {far}"), 2)
            }
            Op::Chosen => (format!("{} of the nearest", at(0, 9)), 2),
            Op::Last => (format!("the last {} by the number of all", at(0, 9)), 2),
            Op::Mean => (format!("the mean of {}", at(0, 9)), 2),
        }
    }

    /// a + bd + cd², or the same of something else.
    fn fade(&self, distance: &Node) -> String {
        match self.at(distance, 6) {
            d if d == "d" => "(a + b d + c d²)".to_owned(),
            d => format!("(a + b {d} + c {d}²)"),
        }
    }

    /// Factors side by side, and a square as such.
    fn product(&self, a: &Node, b: &Node) -> String {
        let (first, second) = (self.at(a, 4), self.at(b, 5));
        let is_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
        match (a, b) {
            (a, b) if a == b => format!("{}²", self.at(a, 6)),
            (Node::Of(Op::Mul, two), b) if two[1] == *b => {
                format!("{} {}²", self.at(&two[0], 4), self.at(b, 6))
            }
            _ if is_number(&second) => format!("{first} · {second}"),
            _ => format!("{first} {second}"),
        }
    }
}

/// A negative number needs parentheses behind an operator.
fn negative(text: String, level: u8) -> String {
    if text.starts_with('−') && 2 < level { format!("({text})") } else { text }
}
