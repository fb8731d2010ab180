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
        let mut all = vec![];
        for axis in 0..3 {
            let mut three = parts(node);
            all.push((2, three[axis].clone()));
            three[axis] = Node::Number(0.0);
            all.push((2, Node::of(Op::Vector, three)));
        }
        if matches!(node, Node::Name(_)) {
            all.push((1, Node::of(Op::Length, [node.clone()])));
            for number in self.names(Kind::Scalar) {
                all.push((2, number));
            }
        }
        all.extend(self.crossed(node));
        all.extend(self.sums(node));
        all
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
        let mut sums = vec![];
        for (k, a) in all.iter().enumerate() {
            for b in &all[..k] {
                sums.push((2, Node::of(Op::Add, [b.clone(), a.clone()])));
            }
        }
        sums
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

    /// A product of two vectors from which a part is missing.
    pub(super) fn without_a_part(&self, a: &Node, b: &Node) -> Vec<Ranked> {
        let (a, b) = (parts(a), parts(b));
        let product =
            |axis: usize| Node::of(Op::Mul, [a[axis].clone(), b[axis].clone()]);
        let two = |[x, y]: [usize; 2]| Node::of(Op::Add, [product(x), product(y)]);
        [[1, 2], [0, 2], [0, 1]].map(|axes| (1, two(axes))).into()
    }

    /// A product of two other vectors.
    pub(super) fn dots(&self) -> Vec<Ranked> {
        let all: Vec<_> = self.names(Kind::Vector).collect();
        let mut dots = vec![];
        for (k, a) in all.iter().enumerate() {
            for b in &all[k..] {
                dots.push((2, Node::of(Op::Dot, [a.clone(), b.clone()])));
            }
        }
        dots
    }

    /// A number that is the length of a vector, or the square of another number of the
    /// same thing, or has that as a factor.
    pub(super) fn measured(&self, node: &Node) -> Vec<Ranked> {
        let mut all = vec![];
        if self.kind(node) == Some(Kind::Scalar) {
            for vector in self.names(Kind::Vector) {
                all.push((2, Node::of(Op::Length, [vector])));
            }
        }
        if self.line.of == Of::Ray {
            return all;
        }
        for name in self.names(Kind::Scalar) {
            let Node::Name(k) = name else { continue };
            if self.tree.lines[k].of == self.line.of {
                all.push((2, Node::of(Op::Pow, [name.clone(), Node::Number(2.0)])));
                for op in [Op::Mul, Op::Div] {
                    all.push((2, Node::of(op, [node.clone(), name.clone()])));
                }
            }
        }
        all
    }
}
