use super::{Ranked, Scope};
use crate::formula::{Kind, Node, Of, Op};

/// x, y and z of a vector.
pub(super) fn parts(node: &Node) -> [Node; 3] {
    [0, 1, 2].map(|axis| Node::of(Op::Part(axis), [node.clone()]))
}

impl Scope<'_> {
    /// A vector of which a part is forgotten or stands for all, or a number for it.
    pub(super) fn reduced(&self, node: &Node) -> Vec<Ranked> {
        if !matches!(self.line.of, Of::Hit | Of::Light) {
            return vec![];
        }
        let flat = |axis: usize| {
            let mut three = parts(node);
            three[axis] = Node::Number(0.0);
            Node::of(Op::Vector, three)
        };
        let numbers =
            self.names(Kind::Scalar).filter(|_| matches!(node, Node::Name(_)));
        let all = parts(node).into_iter().chain([0, 1, 2].map(flat)).chain(numbers);
        let all = all.map(|other| (2, other));
        all.chain(self.crossed(node)).chain(self.sums(node)).collect()
    }

    /// A sum of two directions, or of p and one, for a vector of a light, by its name
    /// or its whole formula.
    fn sums(&self, node: &Node) -> Vec<Ranked> {
        let is_whole = self.line.node.as_ref() == Some(node);
        let is_vector = is_whole || matches!(node, Node::Name(_));
        if self.line.of != Of::Light || !is_vector {
            return vec![];
        }
        let is_one = |node: &Node| match node {
            Node::Name(k) => {
                ["p", "n", "v", "l"].contains(&&*self.tree.lines[*k].name)
            }
            _ => false,
        };
        let all: Vec<_> = self.names(Kind::Vector).filter(is_one).collect();
        let sum = |a: &Node, b: &Node| Node::of(Op::Add, [a.clone(), b.clone()]);
        let pairs = all.iter().enumerate();
        let pairs =
            pairs.flat_map(|(k, a)| all[..k].iter().map(move |b| sum(b, a)));
        pairs.map(|sum| (2, sum)).collect()
    }

    /// A product of two vectors that is another product.
    fn crossed(&self, node: &Node) -> Vec<Ranked> {
        match node {
            Node::Of(Op::Mul, two)
                if two.iter().all(|n| self.kind(n) == Some(Kind::Vector)) =>
            {
                [Op::Dot, Op::Cross].map(|op| (1, Node::of(op, two.clone()))).into()
            }
            _ => vec![],
        }
    }

    /// A product of two other vectors.
    pub(super) fn dots(&self) -> Vec<Ranked> {
        let two = |a: &Node, b: &Node| Node::of(Op::Dot, [a.clone(), b.clone()]);
        let all: Vec<_> = self.names(Kind::Vector).collect();
        let pairs = all.iter().enumerate();
        let pairs =
            pairs.flat_map(|(k, a)| all[k..].iter().map(move |b| two(a, b)));
        pairs.map(|dot| (2, dot)).collect()
    }

    /// A number that is the length of a vector, or the square of another number of the
    /// same thing, or has that as a factor.
    pub(super) fn measured(&self, node: &Node) -> Vec<Ranked> {
        let length = |name: Node| (2, Node::of(Op::Length, [name]));
        let is_scalar = self.kind(node) == Some(Kind::Scalar);
        let vectors = self.names(Kind::Vector).filter(|_| is_scalar);
        let factors = self.names(Kind::Scalar).filter(|name| match name {
            Node::Name(k) => self.tree.lines[*k].of == self.line.of,
            _ => false,
        });
        let products = factors.flat_map(|name| {
            let square = Node::of(Op::Pow, [name.clone(), Node::Number(2.0)]);
            let two = [node.clone(), name];
            let [a, b] = [Op::Mul, Op::Div].map(|op| Node::of(op, two.clone()));
            [square, a, b].map(|other| (2, other))
        });
        let products = products.filter(|_| self.line.of != Of::Ray);
        vectors.map(length).chain(products).collect()
    }
}
