use super::{Ranked, Scope};
use crate::formula::Node;

impl Scope<'_> {
    /// With a name taken for another one everywhere, or two for each other.
    pub(super) fn renamed(&self, node: &Node) -> Vec<Ranked> {
        let mut all = vec![];
        let own: Vec<_> = (0..self.k).filter(|name| node.has(*name)).collect();
        for &a in &own {
            let kind = self.tree.lines[a].kind;
            let swap = |a: usize, b: usize| {
                node.map(&|node| match node {
                    Node::Name(name) if *name == a => Some(Node::Name(b)),
                    Node::Name(name) if *name == b => Some(Node::Name(a)),
                    _ => None,
                })
            };
            for name in self.names(kind) {
                let is_its = |n: &Node| *n == Node::Name(a);
                let other = |n: &Node| is_its(n).then(|| name.clone());
                all.push((1, node.map(&other)));
            }
            let pairs =
                own.iter().filter(|&&b| a < b && self.tree.lines[b].kind == kind);
            for &b in pairs {
                all.push((0, swap(a, b)));
                for &c in own.iter().filter(|&&c| c != a && c != b) {
                    if self.tree.lines[c].kind == kind {
                        all.push((1, cycled(node, [a, b, c])));
                    }
                }
            }
        }
        all
    }
}

/// With a for b, b for c, and c for a.
fn cycled(node: &Node, [a, b, c]: [usize; 3]) -> Node {
    node.map(&|node| match node {
        Node::Name(name) if *name == a => Some(Node::Name(b)),
        Node::Name(name) if *name == b => Some(Node::Name(c)),
        Node::Name(name) if *name == c => Some(Node::Name(a)),
        _ => None,
    })
}

/// With two of its numbers for each other, or with other simple ones for both.
pub(super) fn swapped_numbers(node: &Node) -> Vec<Ranked> {
    let mut found = vec![];
    collect(node, &mut found);
    found.dedup();
    let mut all = vec![];
    for (k, a) in found.iter().enumerate() {
        for b in found.iter().skip(k + 1) {
            let with = |x: f64, y: f64| {
                node.map(&|node| match node {
                    Node::Number(number) if number == a => Some(Node::Number(x)),
                    Node::Number(number) if number == b => Some(Node::Number(y)),
                    _ => None,
                })
            };
            all.push((0, with(*b, *a)));
            if found.len() == 2 && a.fract() != 0.0 && b.fract() != 0.0 {
                let simple =
                    [0.0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 1.0];
                for x in simple {
                    all.extend(simple.map(|y| (1, with(x, y))));
                }
            }
        }
    }
    all
}

fn collect(node: &Node, found: &mut Vec<f64>) {
    match node {
        Node::Number(number) => found.push(*number),
        Node::Of(_, nodes) => nodes.iter().for_each(|node| collect(node, found)),
        _ => {}
    }
}
