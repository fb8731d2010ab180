use super::{Change, Kind, Line, Node, Of, Op, Tree, Value};
use glam::DVec3;
use std::f64::consts::PI;

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
    let mut all = vec![];
    for (k, line) in tree.lines.iter().enumerate().filter(|(_, l)| l.is_needed) {
        if let Some(node) = &line.node {
            let scope = Scope { tree, k, line };
            scope.of_line(node, &mut all);
        } else {
            given(line, k, &mut all);
        }
    }
    exchanges(tree, &mut all);
    rays(tree, &mut all);
    scenes(tree, &mut all);
    for edit in &mut all {
        // Lines that only pass on what another has computed.
        let name = &*tree.lines[edit.line].name;
        let is_alias = ["i'", "j'", "v''", "S", "order", "M"].contains(&name)
            || ["I", "I'"].contains(&name) && edit.rank == 1;
        edit.rank += u8::from(is_alias && edit.says.is_none());
    }
    all.sort_by_key(|edit| edit.rank);
    all
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
            odd.contains(&&*line.name) && self.line.place.stage != "rays"
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
            for (k, below) in nodes.iter().enumerate() {
                for (rank, other) in self.variants(below) {
                    let mut nodes = nodes.clone();
                    nodes[k] = other;
                    all.push((rank, Node::Of(*op, nodes)));
                }
            }
        }
        all
    }

    /// The node changed at its root.
    fn here(&self, node: &Node) -> Vec<Ranked> {
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
            all.push((0, one(Op::Neg)));
            all.push((1, with(Op::Mul, 2.0)));
            all.push((1, with(Op::Div, 2.0)));
            all.push((1, with(Op::Pow, 2.0)));
            all.push((1, with(Op::Pow, 3.0)));
            all.push((1, with(Op::Pow, 4.0)));
            for number in [3.0, 4.0] {
                all.push((2, with(Op::Mul, number)));
                all.push((2, with(Op::Div, number)));
            }
            all.push((1, one(Op::Sqrt)));
            all.push((1, one(Op::Abs)));
            all.push((1, from(Op::Div, 1.0)));
            all.push((1, from(Op::Sub, 1.0)));
            all.push((1, with(Op::Max, 0.0)));
            all.push((1, with(Op::Min, 1.0)));
            all.push((1, with(Op::Add, 1.0)));
            all.push((1, with(Op::Sub, 1.0)));
            all.push((2, with(Op::Mul, 0.5 / PI * 2.0)));
            all.push((2, with(Op::Mul, 180.0 / PI)));
            all.push((2, with(Op::Mul, PI / 180.0)));
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
            all.push((2, one(Op::Acos)));
        }
        if kind == Some(Kind::Vector) {
            all.push((0, one(Op::Unit)));
            let part = |axis: usize| one(Op::Part(axis));
            for (axis, sign) in
                [0, 1, 2].into_iter().flat_map(|k| [(k, 1.0), (k, -1.0)])
            {
                let mut three = [0.0; 3];
                three[axis] = sign;
                all.push((2, Node::of(Op::Vector, three.map(Node::Number))));
            }
            for axes in [[2, 1, 0], [1, 0, 2], [0, 2, 1], [1, 2, 0], [2, 0, 1]] {
                all.push((2, Node::of(Op::Vector, axes.map(part))));
            }
        }
        if let Node::Name(name) = node {
            all.extend(self.counted(&self.tree.lines[*name].name, node));
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
            (Op::If, [truth, a, b]) => {
                all.push((0, a.clone()));
                all.push((0, b.clone()));
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
                    _ => &[],
                };
                all.extend(others.iter().map(|other| of(0, *other)));
                if let (Op::Add, Node::Of(Op::Add, two)) = (op, a) {
                    let last = [two[1].clone(), b.clone()];
                    for other in [Op::Mul, Op::Div] {
                        let last = Node::of(other, last.clone());
                        all.push((1, Node::of(op, [two[0].clone(), last])));
                    }
                }
                if op == Op::Max {
                    all.push((0, Node::of(Op::Abs, [a.clone()])));
                }
                all.extend(regrouped(op, a, b));
            }
            (_, [a]) => {
                all.push((0, a.clone()));
                match op {
                    Op::Tan => {
                        all.extend([Op::Sin, Op::Cos].map(|other| of(0, other)));
                    }
                    Op::Floor => all.push(of(0, Op::Ceil)),
                    Op::Length => {
                        all.push((0, Node::of(Op::Dot, [a.clone(), a.clone()])));
                    }
                    Op::Sum => {
                        all.push(of(0, Op::Alone(0)));
                        all.push(of(0, Op::Alone(1)));
                        all.push(of(1, Op::Product));
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
    fn multiplied(&self, node: &Node) -> Vec<Ranked> {
        if ![Of::Hit, Of::Light].contains(&self.line.of) {
            return vec![];
        }
        let vectors =
            self.names(Kind::Vector).filter(|_| self.line.kind == Kind::Vector);
        let names = self.names(Kind::Scalar).chain(vectors);
        let powers = names.flat_map(|name| {
            let square = Node::of(Op::Pow, [name.clone(), Node::Number(2.0)]);
            [name.clone(), square, Node::of(Op::Sqrt, [name])]
        });
        let all = powers.flat_map(|name| {
            let two = [node.clone(), name];
            [Op::Mul, Op::Div].map(|op| (2, Node::of(op, two.clone())))
        });
        all.collect()
    }

    /// With a name taken for another one everywhere, or two for each other.
    fn renamed(&self, node: &Node) -> Vec<Ranked> {
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
fn swapped_numbers(node: &Node) -> Vec<Ranked> {
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

/// A number of the scene with other signs, or in another order, or of another thing.
fn given(line: &Line, k: usize, all: &mut Vec<Edit>) {
    let mut push = |which: usize, value: Value, rank: u8| {
        let changes = vec![Change::Given(k, which, value)];
        all.push(Edit { changes, rank, says: None, line: k });
    };
    for (which, value) in line.given.iter().enumerate() {
        if value.is_vector() {
            let v = value.vector(0);
            for signs in 1..8 {
                let sign = |bit: i32| if signs & bit == 0 { 1.0 } else { -1.0 };
                let signs = DVec3::new(sign(1), sign(2), sign(4));
                push(which, (v * signs).into(), 0);
            }
            for axes in [[2, 1, 0], [1, 0, 2], [0, 2, 1], [1, 2, 0], [2, 0, 1]] {
                push(which, DVec3::from_array(axes.map(|k| v[k])).into(), 0);
            }
        }
        for other in line.given.iter().filter(|_| 1 < line.given.len()) {
            push(which, other.clone(), 1);
        }
    }
}

/// Two names taken for each other in all lines after theirs.
fn swapped(tree: &Tree, k: usize, l: usize) -> Vec<Change> {
    let swap = |node: &Node| match node {
        Node::Name(name) if *name == k => Some(Node::Name(l)),
        Node::Name(name) if *name == l => Some(Node::Name(k)),
        _ => None,
    };
    let later =
        tree.lines.iter().enumerate().skip(l + 1).filter(|(_, l)| l.is_needed);
    let has = |node: &&Node| node.has(k) || node.has(l);
    let its =
        later.filter_map(|(m, line)| Some((m, line.node.as_ref().filter(has)?)));
    its.map(|(m, node)| Change::Line(m, node.map(&swap))).collect()
}

/// What concerns several lines of the rays, and of the bytes.
fn rays(tree: &Tree, all: &mut Vec<Edit>) {
    let name = |name: &str| tree.find(name).map(Node::Name);
    let (Some(i), Some(j), Some(byte)) =
        (tree.find("i'"), tree.find("j'"), tree.find("B"))
    else {
        return;
    };
    for by in [1.0, -1.0, 0.5, -0.5] {
        let line = |k: usize| match &tree.lines[k].node {
            Some(node) => Node::of(Op::Add, [node.clone(), Node::Number(by)]),
            None => Node::Number(by),
        };
        let changes = vec![Change::Line(i, line(i)), Change::Line(j, line(j))];
        let says = format!(
            "i and j are too large by {by}, as if V_0 were another pixel's"
        )
        .replace('-', "−");
        all.push(Edit { changes, rank: 0, says: Some(says), line: i });
    }
    if let (Some(v), Some(d_u), Some(d_v), Some(v_0), Some(x), Some(y)) = (
        tree.find("V"),
        name("D_u"),
        name("D_v"),
        name("V_0"),
        name("i'"),
        name("j'"),
    ) {
        let place = Node::of(Op::Vector, [x, y, Node::Number(1.0)]);
        let rows =
            [d_u, d_v, v_0].map(|row| Node::of(Op::Dot, [row, place.clone()]));
        let says = "D_u, D_v and V_0 are the rows of the matrix, not its columns"
            .to_owned();
        let changes = vec![Change::Line(v, Node::of(Op::Vector, rows))];
        all.push(Edit { changes, rank: 0, says: Some(says), line: v });
    }
    if let Some(node) = &tree.lines[byte].node {
        let turns = Node::of(
            Op::Floor,
            [Node::of(Op::Div, [node.clone(), Node::Number(256.0)])],
        );
        let all_turns = Node::of(Op::Mul, [Node::Number(256.0), turns]);
        let changes =
            vec![Change::Line(byte, Node::of(Op::Sub, [node.clone(), all_turns]))];
        let says =
            "bytes above 255 wrap, they begin again at 0: modulo 256, not clamped"
                .to_owned();
        all.push(Edit { changes, rank: 0, says: Some(says), line: byte });
    }
}

/// Two lines that have changed places.
fn exchanges(tree: &Tree, all: &mut Vec<Edit>) {
    let lines = || {
        let all = tree.lines.iter().enumerate();
        all.filter(|(_, l)| l.is_needed && !l.is_function)
    };
    for (k, one) in lines() {
        for (l, two) in lines().filter(|(l, _)| k < *l && *l < k + 6) {
            let is_like = one.kind == two.kind && one.of == two.of;
            if let (true, Some(a), Some(b)) = (is_like, &one.node, &two.node) {
                // The first can't need what is not computed yet.
                let changes = match tree.uses(b) >> k {
                    0 => {
                        vec![Change::Line(k, b.clone()), Change::Line(l, a.clone())]
                    }
                    _ => swapped(tree, k, l),
                };
                let [first, second] =
                    [one, two].map(|line| super::shown(&line.name));
                let says = format!("{first} and {second} have changed places");
                all.push(Edit { changes, rank: 1, says: Some(says), line: k });
            }
        }
    }
}

/// What may be wrong with the list of objects, or of lights.
fn scenes(tree: &Tree, all: &mut Vec<Edit>) {
    let mut push = |line: &str, rank: u8, changes: Vec<Change>, says: String| {
        if let Some(line) = tree.find(line).filter(|k| tree.lines[*k].is_needed) {
            all.push(Edit { changes, rank, says: Some(says), line });
        }
    };
    let count = tree.count(Of::Object);
    if let Some(order) = tree.find("order").filter(|_| 1 < count) {
        let t = tree.find("t").unwrap_or(order);
        let minus = Node::of(Op::Neg, [Node::Name(t)]);
        let far = "the farthest hit wins, that with the largest t".to_owned();
        push("order", 0, vec![Change::Line(order, minus)], far);
        let size = Node::of(Op::Neg, [Node::of(Op::Abs, [Node::Name(t)])]);
        let far = "the hit with the largest |t| wins, the farthest".to_owned();
        push("order", 1, vec![Change::Line(order, size)], far);
        let zero = vec![Change::Line(order, Node::Number(0.0))];
        push("order", 0, zero, "the first hit of the list wins".to_owned());
        if let Some(k) = tree.find("number") {
            let last = Node::of(Op::Neg, [Node::Name(k)]);
            let says = "the last hit of the list wins".to_owned();
            push("order", 0, vec![Change::Line(order, last)], says);
        }
        for k in 0..count {
            let name = tree.object(k);
            push(
                "nearest",
                if k == 0 || k == count - 1 { 0 } else { 1 },
                vec![Change::Without(k)],
                format!("{name} is left out, the one at place {k} of the list"),
            );
            if 1 < k && k < count - 1 {
                let names: Vec<_> = (k..count).map(|k| tree.object(k)).collect();
                push(
                    "nearest",
                    1,
                    vec![Change::Objects(0, k)],
                    format!(
                        "only the first {k} objects count, without {}",
                        names.join(", ")
                    ),
                );
            }
        }
        materials(tree, &mut push);
    }
    lamps(tree, &mut push);
    if let (Some(line), Some(ambient), Some(one)) =
        (tree.find("I"), tree.find("I_a"), tree.find("I_d"))
        && tree.lines[one].is_needed
    {
        let of = |op: Op| Node::of(op, [Node::Name(one)]);
        let product = Node::of(Op::Mul, [Node::Name(ambient), of(Op::Product)]);
        let says =
            "I_a and the I_d of the lights are multiplied, not added".to_owned();
        push("E_d", 0, vec![Change::Line(line, product)], says);
        let last = vec![Change::Line(line, of(Op::Alone(1)))];
        let says = "I is the I_d of the last light alone: the ambient part and the first \
                    light are missing";
        push("E_d", 0, last, says.to_owned());
    }
}

/// One object's shape or material for all.
fn materials(tree: &Tree, push: &mut impl FnMut(&str, u8, Vec<Change>, String)) {
    let last = tree.count(Of::Object) - 1;
    for k in [0, last] {
        for (names, what) in [
            (&["centre'", "radius'"][..], "the point's sphere, of its normal,"),
            (
                &["centre'", "radius'", "colour'", "g'", "n'"],
                "the sphere and the material of every hit",
            ),
            (
                &["colour'", "g'", "n'"],
                "the material of every point, R_a, R_d, R_s and n,",
            ),
        ] {
            let lines = names.iter().filter_map(|name| tree.find(name));
            let lines = lines.filter(|k| tree.lines[*k].is_needed);
            let change = |line: usize| match &tree.lines[line].node {
                Some(Node::Of(_, nodes)) => {
                    Change::Line(line, Node::of(Op::Alone(k), nodes.clone()))
                }
                _ => Change::Without(usize::MAX),
            };
            let changes: Vec<_> = lines.map(change).collect();
            let says = format!("{what} is that of {}", tree.object(k));
            let line = match names.len() {
                2 => "n",
                5 => "nearest",
                _ => names[0],
            };
            push(line, 1, changes, says);
        }
    }
}

/// One lamp for another, or numbers of two things that have changed places.
fn lamps(tree: &Tree, push: &mut impl FnMut(&str, u8, Vec<Change>, String)) {
    for name in ["P", "L_d", "L_s"] {
        let Some(k) = tree.find(name) else { continue };
        let [warm, cool] = [0, 1].map(|which| tree.lines[k].given[which].clone());
        let changes = vec![Change::Given(k, 0, cool), Change::Given(k, 1, warm)];
        let says = format!("{name} of the two lights have changed places");
        push(if name == "L_s" { "I_s" } else { "I_d" }, 1, changes, says);
    }
    if let (Some(g), Some(n)) = (tree.find("g"), tree.find("n''")) {
        let count = tree.lines[g].given.len();
        for (a, b) in (0..count).flat_map(|a| (0..a).map(move |b| (b, a))) {
            let of = |k: usize, a: usize, b: usize| {
                Change::Given(k, a, tree.lines[k].given[b].clone())
            };
            let changes = vec![of(g, a, b), of(g, b, a), of(n, a, b), of(n, b, a)];
            let says = format!(
                "R_s and n of {} and of {} have changed places",
                tree.object(b),
                tree.object(a)
            );
            push("R_s", 1, changes, says);
        }
    }
    for (lamp, other) in [(0, 1), (1, 0)] {
        let name = |lamp: usize| ["warm", "cool"][lamp];
        for line in ["I_d", "I_s"] {
            let Some(k) = tree.find(line) else { continue };
            let what = if line == "I_d" { "L_d" } else { "L_s" };
            push(
                line,
                1,
                vec![Change::Lamp(k, lamp)],
                format!(
                    "the {} light has the {what} and the attenuation of the {} one in {line}",
                    name(other),
                    name(lamp)
                ),
            );
        }
        for own in [
            &["P", "L_d", "a'", "b'", "c'"][..],
            &["P", "L_d", "L_s", "a'", "b'", "c'"],
            &["a'", "b'", "c'"],
            &["L_d", "a'", "b'", "c'"],
        ] {
            let all = own.iter().filter_map(|name| tree.find(name));
            let given = |k: usize| {
                Change::Given(k, other, tree.lines[k].given[lamp].clone())
            };
            let changes: Vec<_> = all.map(given).collect();
            let shown: Vec<_> =
                own.iter().map(|n| n.trim_end_matches('\'')).collect();
            push(
                if own[0] == "a'" { "fade" } else { "I_d" },
                1,
                changes,
                format!(
                    "the {} light has {} of the {} one",
                    name(other),
                    shown.join(", "),
                    name(lamp)
                ),
            );
        }
    }
}
