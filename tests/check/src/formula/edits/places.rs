use super::terms::terms;
use super::vectors::parts;
use super::{Ranked, Scope};
use crate::formula::{Kind, Node, Of, Op};
use std::f64::consts::PI;

/// How far-fetched an operation with a number is, put in.
const WITH: [(u8, Op, f64); 18] = [
    (1, Op::Mul, 2.0),
    (1, Op::Div, 2.0),
    (1, Op::Pow, 2.0),
    (1, Op::Max, 0.0),
    (1, Op::Min, 1.0),
    (1, Op::Add, 1.0),
    (1, Op::Sub, 1.0),
    (2, Op::Pow, 3.0),
    (2, Op::Pow, 4.0),
    (2, Op::Max, 1.0),
    (2, Op::Min, 0.0),
    (2, Op::Mul, 3.0),
    (2, Op::Div, 3.0),
    (2, Op::Mul, 4.0),
    (2, Op::Div, 4.0),
    // π and degrees, put in or left out.
    (2, Op::Mul, 1.0 / PI),
    (2, Op::Mul, 180.0 / PI),
    (2, Op::Mul, PI / 180.0),
];

/// The axes of a vector in another order, and some of them taken twice.
pub(super) const ORDERS: [[usize; 3]; 5] =
    [[2, 1, 0], [1, 0, 2], [0, 2, 1], [1, 2, 0], [2, 0, 1]];
const TWICE: [[usize; 3]; 6] =
    [[0, 1, 1], [0, 0, 2], [0, 1, 0], [0, 2, 2], [1, 1, 2], [2, 1, 2]];

impl Scope<'_> {
    /// The node changed at its root.
    pub(super) fn here(&self, node: &Node) -> Vec<Ranked> {
        let mut all = match node {
            Node::Number(number) => numbers(*number),
            Node::Of(op, nodes) => self.operation(*op, nodes),
            _ => vec![],
        };
        let kind = self.kind(node);
        let one = |op: Op| Node::of(op, [node.clone()]);
        let with = |op: Op, number: f64| {
            Node::of(op, [node.clone(), Node::Number(number)])
        };
        let from = |op: Op, number: f64| {
            Node::of(op, [Node::Number(number), node.clone()])
        };
        let is_number = matches!(node, Node::Number(_));
        if kind != Some(Kind::Truth) && !is_number {
            // Hardly anyone changes the sign of a column, a row or a radius.
            let plain = ["i", "j", "radius", "radius'"];
            let is_plain = plain.contains(&&*self.line.name);
            all.push((u8::from(is_plain), one(Op::Neg)));
            for (rank, op, number) in WITH {
                all.push((rank, with(op, number)));
            }
            for op in [Op::Sqrt, Op::Abs] {
                all.push((1, one(op)));
            }
            for op in [Op::Div, Op::Sub] {
                all.push((1, from(op, 1.0)));
            }
            let rest = Node::of(Op::Div, [node.clone(), with(Op::Add, 1.0)]);
            all.push((2, rest));
            for number in [0.0, 1.0] {
                all.push((1, Node::Number(number)));
            }
            for name in
                self.names(Kind::Vector).filter(|_| kind == Some(Kind::Vector))
            {
                all.push((2, Node::of(Op::Neg, [name.clone()])));
                let unit = Node::of(Op::Unit, [name]);
                all.push((2, Node::of(Op::Neg, [unit.clone()])));
                all.push((2, unit));
            }
            for name in self.names(kind.unwrap_or(Kind::Scalar)) {
                all.push((if matches!(node, Node::Name(_)) { 1 } else { 2 }, name));
            }
        }
        if kind == Some(Kind::Scalar) && !is_number {
            all.push((
                2,
                Node::of(Op::Div, [with(Op::Add, 1.0), Node::Number(2.0)]),
            ));
            let square = from(Op::Sub, 1.0)
                .map(&|n| (n == node).then(|| with(Op::Pow, 2.0)));
            all.push((2, Node::of(Op::Sqrt, [square])));
            for op in [Op::Acos, Op::Cos, Op::Sin] {
                all.push((2, one(op)));
            }
        }
        if kind == Some(Kind::Vector) {
            all.push((0, one(Op::Unit)));
            for (axis, sign) in
                [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)]
            {
                let mut three = [0.0; 3];
                three[axis] = sign;
                all.push((2, Node::of(Op::Vector, three.map(Node::Number))));
            }
            // A channel may be taken for another one.
            let is_colour = matches!(node, Node::Of(Op::Chosen, _));
            let twice = if is_colour { &TWICE[..] } else { &[] };
            let orders = ORDERS.iter().map(|axes| (2, axes));
            for (rank, axes) in orders.chain(twice.iter().map(|axes| (1, axes))) {
                let part = |axis: usize| one(Op::Part(axis));
                all.push((rank, Node::of(Op::Vector, axes.map(part))));
            }
            all.extend(self.reduced(node));
        }
        if self.line.of == Of::Pixel && matches!(node, Node::Name(_)) {
            // Whole numbers, too soon.
            for whole in [node.clone(), with(Op::Add, 0.5)] {
                all.push((1, Node::of(Op::Floor, [whole])));
            }
        }
        if let Node::Name(name) = node {
            all.extend(self.counted(&self.tree.lines[*name].name, node));
        }
        if matches!(node, Node::Name(_) | Node::Of(Op::Call(_), _)) {
            all.extend(self.measured(node));
        }
        all
    }

    /// Counted from the other end.
    fn counted(&self, name: &str, node: &Node) -> Vec<Ranked> {
        let ends = match name {
            "column" | "i" => ["hRes", "vRes"],
            "row" | "j" => ["vRes", "hRes"],
            _ => return vec![],
        };
        let end = ends.into_iter().filter_map(|end| self.tree.find(end));
        end.flat_map(|end| {
            let end = Node::Name(end);
            let less = Node::of(Op::Sub, [end.clone(), Node::Number(1.0)]);
            [end, less].map(|end| (0, Node::of(Op::Sub, [end, node.clone()])))
        })
        .collect()
    }

    fn operation(&self, op: Op, nodes: &[Node]) -> Vec<Ranked> {
        let of = |rank: u8, op: Op| (rank, Node::of(op, nodes));
        let mut all = vec![];
        match (op, nodes) {
            (Op::Nearest, _) => {}
            (Op::If, [truth, a, b]) => {
                all.push((0, a.clone()));
                all.push((0, b.clone()));
                let none = Node::Number(0.0);
                all.push((
                    0,
                    Node::of(op, [truth.clone(), none.clone(), b.clone()]),
                ));
                all.push((0, Node::of(op, [truth.clone(), a.clone(), none])));
                all.push((1, Node::of(op, [truth.clone(), b.clone(), a.clone()])));
            }
            (Op::Vector, [x, y, z]) => {
                let three = [x, y, z];
                for which in 0..27 {
                    let axes = [which % 3, which / 3 % 3, which / 9];
                    let three = axes.map(|axis| three[axis].clone());
                    all.push((0, Node::of(op, three)));
                }
                for signs in 1..8 {
                    let sign = |axis: usize| match signs >> axis & 1 {
                        0 => three[axis].clone(),
                        _ => Node::of(Op::Neg, [three[axis].clone()]),
                    };
                    all.push((0, Node::of(op, [0, 1, 2].map(sign))));
                }
            }
            (_, [a, b]) => {
                all.push((0, a.clone()));
                all.push((0, b.clone()));
                all.push((0, Node::of(op, [b.clone(), a.clone()])));
                let others: &[Op] = match op {
                    Op::Add | Op::Sub => &[Op::Add, Op::Sub, Op::Mul, Op::Div],
                    Op::Mul | Op::Div => &[Op::Mul, Op::Div, Op::Add, Op::Sub],
                    Op::Pow => &[Op::Mul, Op::Div],
                    Op::Max => &[Op::Min],
                    Op::Dot => &[Op::Mul],
                    _ => &[],
                };
                all.extend(others.iter().map(|other| of(0, *other)));
                let turned = others.iter().filter(|other| **other != op);
                let turned = turned.map(|op| Node::of(*op, [b.clone(), a.clone()]));
                all.extend(turned.map(|other| (1, other)));
                if let (Op::Add, Node::Of(Op::Add, two)) = (op, a) {
                    all.extend([(0, two[0].clone()), (0, two[1].clone())]);
                    let last = [two[1].clone(), b.clone()];
                    for other in [Op::Mul, Op::Div] {
                        let last = Node::of(other, last.clone());
                        all.push((1, Node::of(op, [two[0].clone(), last])));
                    }
                }
                if op == Op::Max {
                    all.push((0, Node::of(Op::Abs, [a.clone()])));
                }
                if op == Op::Dot && self.line.of == Of::Light {
                    all.extend(self.dots());
                }
                if op == Op::Dot && self.line.of == Of::Object {
                    all.extend(self.without_a_part(a, b));
                }
                let is_vector = |n: &Node| self.kind(n) == Some(Kind::Vector);
                if matches!(op, Op::Add | Op::Sub) && is_vector(a) && is_vector(b) {
                    let unit = |n: &Node| Node::of(Op::Unit, [n.clone()]);
                    all.push((1, Node::of(op, [unit(a), unit(b)])));
                }
                all.extend(regrouped(op, a, b));
                all.extend(terms(op, a, b));
            }
            (_, [a]) => {
                all.push((0, a.clone()));
                match op {
                    Op::Tan => {
                        let others = [Op::Sin, Op::Cos, Op::Atan];
                        all.extend(others.map(|other| of(0, other)));
                    }
                    Op::Floor => all.push(of(0, Op::Ceil)),
                    Op::Length => {
                        all.push((0, Node::of(Op::Dot, [a.clone(), a.clone()])));
                        all.extend(parts(a).map(|x| (1, Node::of(Op::Abs, [x]))));
                    }
                    Op::Unit => {
                        let square = Node::of(Op::Dot, [a.clone(), a.clone()]);
                        all.push((1, Node::of(Op::Div, [a.clone(), square])));
                    }
                    Op::Sum => {
                        all.push(of(0, Op::Alone(0)));
                        all.push(of(0, Op::Alone(1)));
                        all.push(of(1, Op::Product));
                        all.push(of(1, Op::Most));
                        // It begins with something.
                        for name in self.names(Kind::Vector) {
                            let sum = Node::of(op, nodes);
                            all.push((2, Node::of(Op::Add, [name, sum])));
                        }
                    }
                    Op::Chosen => {
                        all.push(of(1, Op::Alone(0)));
                        let last = self.tree.count(Of::Object) - 1;
                        all.push(of(1, Op::Alone(last)));
                    }
                    _ => {}
                }
            }
            _ => {}
        }
        all
    }

    /// Multiplied by something else, or divided by it.
    pub(super) fn multiplied(&self, node: &Node) -> Vec<Ranked> {
        if ![Of::Hit, Of::Light].contains(&self.line.of) {
            return vec![];
        }
        let vectors =
            self.names(Kind::Vector).filter(|_| self.line.kind == Kind::Vector);
        let names = self.names(Kind::Scalar).chain(vectors);
        let mut factors = vec![];
        for name in names {
            let square = Node::of(Op::Pow, [name.clone(), Node::Number(2.0)]);
            factors.extend([name.clone(), square, Node::of(Op::Sqrt, [name])]);
        }
        // What makes a wider lobe darker, in other books.
        let n = self.tree.find("n'").filter(|_| &*self.line.name == "I_s");
        if let Some(n) = n {
            for (by, below) in
                [(1.0, 2.0 * PI), (2.0, 2.0 * PI), (8.0, 8.0 * PI), (2.0, 8.0 * PI)]
            {
                let more = Node::of(Op::Add, [Node::Name(n), Node::Number(by)]);
                factors.push(Node::of(Op::Div, [more, Node::Number(below)]));
            }
        }
        let mut all = vec![];
        for factor in factors {
            let two = [node.clone(), factor];
            all.extend([Op::Mul, Op::Div].map(|op| (2, Node::of(op, &two))));
        }
        all
    }
}

/// Other numbers for one of the lecture.
fn numbers(k: f64) -> Vec<Ranked> {
    let all = [0.0, 1.0, -k, 2.0 * k, k / 2.0, 1.0 / k, 10.0 * k, k / 10.0, k * k];
    let all = all.into_iter().chain([k + 1.0, k - 1.0, 0.5, -0.5, 0.999 + k]);
    let all = all.filter(|other| *other != k && other.is_finite());
    all.map(|other| (0, Node::Number(other))).collect()
}

/// With parentheses elsewhere.
fn regrouped(op: Op, a: &Node, b: &Node) -> Vec<Ranked> {
    let mut all = vec![];
    let of = |op: Op, a: &Node, b: Node| Node::of(op, [a.clone(), b]);
    if let Node::Of(inner, two) = a {
        match &two[..] {
            [x, y] => all.push(of(*inner, x, of(op, y, b.clone()))),
            [x] => all.push(Node::of(*inner, [of(op, x, b.clone())])),
            _ => {}
        }
    }
    if let Node::Of(inner, two) = b {
        match &two[..] {
            [x, y] => all.push(Node::of(*inner, [of(op, a, x.clone()), y.clone()])),
            [x] => all.push(Node::of(*inner, [of(op, a, x.clone())])),
            _ => {}
        }
    }
    // A sum or a product begins with what is on the left of the parentheses.
    if let (Node::Of(first, x), Node::Of(second, y)) = (a, b)
        && let ([x, y], [z, w]) = (&x[..], &y[..])
    {
        let middle = of(op, y, z.clone());
        all.push(Node::of(*second, [of(*first, x, middle), w.clone()]));
    }
    all.into_iter().map(|node| (0, node)).collect()
}
