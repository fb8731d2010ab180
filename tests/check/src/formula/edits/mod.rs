mod lines;
mod names;
mod places;
mod scene;
mod terms;
mod vectors;

use super::{Change, Kind, Line, Node, Of, Op, Tree};
use crate::{each, sort};
use lines::{exchanges, rays};
use names::swapped_numbers;
use scene::{given, scenes};
use terms::fades;

/// One thing done otherwise than in the lecture.
#[derive(Clone, Debug)]
pub(crate) struct Edit {
    pub changes: Vec<Change>,
    /// How far-fetched it is: 0 for a slip of the hand.
    pub rank: u8,
    /// In words, where it is no other formula.
    pub says: Option<String>,
    /// The line that it belongs to.
    pub line: usize,
}

/// Every edit of every line, the likeliest first.
pub(crate) fn edits(tree: &Tree) -> Vec<Edit> {
    let of = |(k, line): (usize, &Line)| {
        let mut all = vec![];
        match &line.node {
            Some(node) => Scope { tree, k, line }.of_line(node, &mut all),
            None => given(line, k, &mut all),
        }
        Some(all)
    };
    let lines = tree.lines.iter().enumerate().filter(|(_, l)| l.is_needed);
    let all = each(lines.collect(), of).into_iter();
    let mut all: Vec<_> = all.flatten().collect();
    exchanges(tree, &mut all);
    rays(tree, &mut all);
    scenes(tree, &mut all);
    for edit in &mut all {
        // Lines that only pass on what another has computed.
        let name = &*tree.lines[edit.line].name;
        let is_alias = ["i'", "j'", "v''", "S", "order", "M"].contains(&name)
            || name == "I'" && edit.rank == 1
            || name == "I" && edit.rank == 1 && !is_of_sum(tree, edit);
        edit.rank += u8::from(is_alias && edit.says.is_none());
    }
    sort(&mut all, |edit| [usize::from(edit.rank), 0]);
    all
}

/// Whether an edit of a sum is of the whole, or takes one of its terms for another.
fn is_of_sum(tree: &Tree, edit: &Edit) -> bool {
    let (Some(ours), [Change::Line(_, other)]) =
        (&tree.lines[edit.line].node, &edit.changes[..])
    else {
        return false;
    };
    let is_term = |node: &Node| match node {
        Node::Name(name) => ours.has(*name),
        Node::Of(op, _) => *op == Op::Add,
        _ => false,
    };
    other.any(&|node| node == ours) || !other.any(&|node| !is_term(node))
}

/// The places of some lines, where there are all of them.
fn all_found<const N: usize>(tree: &Tree, names: [&str; N]) -> Option<[usize; N]> {
    let all = names.map(|name| tree.find(name));
    all.iter().all(Option::is_some).then(|| all.map(Option::unwrap_or_default))
}

/// A line, and the names that may stand in it.
struct Scope<'a> {
    tree: &'a Tree,
    k: usize,
    line: &'a Line,
}

type Ranked = (u8, Node);

impl Scope<'_> {
    fn of_line(&self, node: &Node, all: &mut Vec<Edit>) {
        let mut others = self.variants(node);
        others.extend(self.renamed(node));
        others.extend(swapped_numbers(node));
        others.extend(self.multiplied(node));
        if &*self.line.name == "fade" {
            others.extend(fades(node));
        }
        if &*self.line.name == "M" {
            others.push((
                1,
                node.map(&|n| match n {
                    Node::Of(Op::Mean, nodes) => {
                        Some(Node::of(Op::Last, nodes.clone()))
                    }
                    _ => None,
                }),
            ));
        }
        for (rank, other) in others {
            let kind = self.kind(&other);
            let is_fit = kind == Some(self.line.kind)
                || kind == Some(Kind::Scalar) && self.line.kind == Kind::Vector;
            if is_fit && other != *node {
                let changes = vec![Change::Line(self.k, other)];
                all.push(Edit { changes, rank, says: None, line: self.k });
            }
        }
    }

    fn kind(&self, node: &Node) -> Option<Kind> {
        node.kind(&|name| self.tree.lines[name].kind)
    }

    /// The names of a kind that may stand in the line.
    fn names(&self, kind: Kind) -> impl Iterator<Item = Node> {
        let lines = self.tree.lines.iter().enumerate().take(self.k);
        let is_seen = move |line: &Line| match line.of {
            _ if self.line.of == Of::Pixel => line.of == Of::Pixel,
            Of::Ray => true,
            Of::Hit => self.line.of == Of::Hit || self.line.of == Of::Light,
            of => of == self.line.of,
        };
        let is_odd = |line: &Line| {
            let odd = [
                "fade", "order", "nearest", "k_u", "k_v", "samples", "I'", "fov",
                "θ",
            ];
            // A column or a row is of no use where light falls on a point.
            let counted = [
                "hRes", "vRes", "columns", "rows", "column", "row", "u", "v'", "i",
                "j", "i'", "j'",
            ];
            let is_lit = matches!(self.line.of, Of::Hit | Of::Light);
            odd.contains(&&*line.name) && self.line.place.stage != "rays"
                || is_lit && counted.contains(&&*line.name)
        };
        let is_it = move |line: &&Line| {
            line.is_needed
                && !line.is_function
                && line.kind == kind
                && is_seen(line)
                && !is_odd(line)
        };
        lines.filter(move |(_, l)| is_it(l)).map(|(k, _)| Node::Name(k))
    }

    /// The node with one place of it changed, in every way.
    fn variants(&self, node: &Node) -> Vec<Ranked> {
        let mut all = self.here(node);
        if let Node::Of(op, nodes) = node {
            if matches!(op, Op::Chosen | Op::Nearest | Op::Sum) {
                return all;
            }
            let is_product = |op: &Op| matches!(op, Op::Mul | Op::Div);
            for (k, below) in nodes.iter().enumerate() {
                let is_in_product = k == 0
                    && is_product(op)
                    && matches!(below, Node::Of(op, _) if is_product(op));
                for (rank, other) in self.variants(below) {
                    // A sum would need parentheses there, which no slip adds.
                    let is_sum = matches!(other, Node::Of(Op::Add | Op::Sub, _));
                    if is_in_product && is_sum {
                        continue;
                    }
                    let mut nodes = nodes.clone();
                    nodes[k] = other;
                    all.push((rank, Node::Of(*op, nodes)));
                }
            }
        }
        all
    }
}
