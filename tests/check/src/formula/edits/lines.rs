use super::{Edit, all_found};
use crate::formula::{Change, Node, Op, Tree, shown};
use crate::measure::number;

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
pub(super) fn rays(tree: &Tree, all: &mut Vec<Edit>) {
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
            "i and j are too large by {}, as if V_0 were another pixel's",
            number(by)
        );
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
    if let Some([columns, rows, width, height]) =
        all_found(tree, ["columns", "rows", "hRes", "vRes"])
    {
        let pairs = [(columns, width), (rows, height)];
        let changes = pairs.map(|(line, of)| Change::Line(line, Node::Name(of)));
        let changes = changes.into();
        all.push(Edit { changes, rank: 0, says: None, line: columns });
    }
    last_samples(tree, all);
    weights(tree, all);
    samples_in_bytes(tree, all);
    steps(tree, all);
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
        let most = Node::of(Op::Min, [node.clone(), Node::Number(127.0)]);
        let says = "bytes end at 127, as those with a sign do".to_owned();
        let changes = vec![Change::Line(byte, most)];
        all.push(Edit { changes, rank: 0, says: Some(says), line: byte });
    }
    whole(tree, byte, all);
}

/// Bytes of intensities that are taken for numbers from -1 to 1, and n that is divided as
/// whole numbers are, without a rest.
fn whole(tree: &Tree, byte: usize, all: &mut Vec<Edit>) {
    let of = |op: Op, a: Node, b: f64| Node::of(op, [a, Node::Number(b)]);
    let mut push = |line: usize, node: Node| {
        let changes = vec![Change::Line(line, Node::of(Op::Floor, [node]))];
        all.push(Edit { changes, rank: 1, says: None, line });
    };
    if let Some(mean) = tree.find("M") {
        let twice = of(Op::Add, Node::Name(mean), 1.0);
        let times = Node::of(Op::Mul, [Node::Number(127.5), twice]);
        push(byte, of(Op::Add, times, 0.5));
    }
    let n = tree.find("n'").map(|n| (n, &tree.lines[n]));
    let n = n.filter(|(_, line)| line.is_needed);
    if let Some((n, node)) = n.and_then(|(n, line)| Some((n, line.node.as_ref()?)))
    {
        for k in [3.0, 4.0, 5.0, 8.0, 10.0] {
            push(n, of(Op::Div, node.clone(), k));
        }
    }
}

/// A step from pixel to pixel that is divided by something else and has lost its 2, too;
/// or that is multiplied by the ratio of the sides, or by one of them; or that goes ahead,
/// too, by a part of 1.
fn steps(tree: &Tree, all: &mut Vec<Edit>) {
    let Some([h, rows, columns, width, height, d_u, d_v]) =
        all_found(tree, ["h", "rows", "columns", "hRes", "vRes", "D_u", "D_v"])
    else {
        return;
    };
    let of = |op: Op, a: Node, b: usize| Node::of(op, [a, Node::Name(b)]);
    for (line, axis) in [(d_u, 0), (d_v, 1)] {
        let Some(Node::Of(Op::Vector, three)) = &tree.lines[line].node else {
            return;
        };
        let half = |by: usize| {
            let half = of(Op::Div, Node::Name(h), by);
            if axis == 0 { half } else { Node::of(Op::Neg, [half]) }
        };
        let Node::Of(Op::Div, two) = &three[axis] else { return };
        let by = |(a, b): (usize, usize)| {
            let above = of(Op::Mul, two[0].clone(), a);
            of(Op::Div, Node::of(Op::Div, [above, two[1].clone()]), b)
        };
        let mut others = vec![];
        for side in [rows, width, height] {
            let times = of(Op::Mul, two[0].clone(), side);
            let times = Node::of(Op::Div, [times, two[1].clone()]);
            others.extend([(axis, half(side)), (axis, times)]);
        }
        for ratio in
            [(rows, columns), (columns, rows), (height, width), (width, height)]
        {
            others.push((axis, by(ratio)));
        }
        for side in [rows, columns] {
            others.push((2, of(Op::Div, Node::Number(-1.0), side)));
        }
        for (axis, step) in others {
            let mut three = three.clone();
            three[axis] = step;
            let changes = vec![Change::Line(line, Node::of(Op::Vector, three))];
            all.push(Edit { changes, rank: 1, says: None, line });
        }
    }
}

/// The last sub-pixel alone, divided by the number of all: in a picture that seems to
/// have one.
fn last_samples(tree: &Tree, all: &mut Vec<Edit>) {
    let [i, j, mean] = ["i", "j", "M"].map(|name| tree.find(name));
    let (Some(i), Some(j), Some(mean)) = (i, j, mean) else {
        return;
    };
    for side in [2, 3, 4] {
        let rays = f64::from(side);
        let offset = Node::Number(0.5 - 0.5 / rays);
        let other = |line: usize, op: Op, by: Node| {
            let node = tree.lines[line].node.clone();
            Some(Change::Line(line, Node::of(op, [node?, by])))
        };
        let weight = Node::Number(1.0 / (rays * rays));
        let changes = [
            other(i, Op::Add, offset.clone()),
            other(j, Op::Add, offset),
            other(mean, Op::Mul, weight),
        ];
        let says = format!(
            "of {side} × {side} samples in a pixel the last one alone is kept, and \
             divided by the number of all"
        );
        let changes = changes.into_iter().flatten().collect();
        all.push(Edit { changes, rank: 1, says: Some(says), line: i });
    }
}

/// The sum of the samples divided by another number than that of all, and samples that are
/// a whole pixel apart: in a picture of several rays a pixel.
fn weights(tree: &Tree, all: &mut Vec<Edit>) {
    let Some([mean, offset, samples]) = all_found(tree, ["M", "offset", "samples"])
    else {
        return;
    };
    let side = tree.lines[samples].given[0].scalar(0);
    let Some(node) = tree.lines[mean].node.clone().filter(|_| 1.0 < side) else {
        return;
    };
    let shown = number(side);
    let of = |op: Op, a: Node, b: f64| Node::of(op, [a, Node::Number(b)]);
    for (by, what) in
        [(1.0, "not divided"), (side, "divided by "), (2.0 * side, "divided by ")]
    {
        let changes =
            vec![Change::Line(mean, of(Op::Mul, node.clone(), side * side / by))];
        let by = if by == 1.0 { String::new() } else { number(by) };
        let says = format!("the sum of {shown} × {shown} samples is {what}{by}");
        all.push(Edit { changes, rank: 0, says: Some(says), line: mean });
    }
    let apart = of(Op::Add, Node::Argument, 0.5 - side / 2.0);
    let says =
        format!("the {shown} × {shown} samples of a pixel are a pixel apart");
    let changes = vec![Change::Line(offset, apart)];
    all.push(Edit { changes, rank: 0, says: Some(says), line: offset });
}

/// Bytes of each sample, and their mean: in a picture of several rays a pixel.
fn samples_in_bytes(tree: &Tree, all: &mut Vec<Edit>) {
    let Some([ray, byte, mean]) = all_found(tree, ["I'", "B", "M"]) else { return };
    let samples = tree.find("samples").map(|k| tree.lines[k].given[0].scalar(0));
    let Some(colour) = &tree.lines[ray].node else { return };
    if samples == Some(1.0) {
        return;
    }
    let of = |op: Op, a: Node, b: f64| Node::of(op, [a, Node::Number(b)]);
    let floor = |node: Node| Node::of(Op::Floor, [node]);
    let whole = of(Op::Mul, colour.clone(), 255.0);
    for (half, how) in [(0.5, "rounded"), (0.0, "cut off")] {
        let bytes = floor(of(Op::Add, whole.clone(), half));
        let clamped = of(Op::Min, of(Op::Max, bytes.clone(), 0.0), 255.0);
        for bytes in [clamped, bytes] {
            let mean = Node::Name(mean);
            let rounded = floor(of(Op::Add, mean.clone(), 0.5));
            let again = of(Op::Div, bytes.clone(), 255.0);
            for (bytes, last) in [
                (&bytes, Some(floor(mean))),
                (&bytes, Some(rounded)),
                (&again, None),
            ] {
                let mut changes = vec![Change::Line(ray, bytes.clone())];
                changes.extend(last.map(|last| Change::Line(byte, last)));
                let says = format!(
                    "each sample is {how} to a byte, before the mean of all is taken"
                );
                all.push(Edit { changes, rank: 0, says: Some(says), line: byte });
            }
        }
    }
}

/// Two lines that have changed places.
pub(super) fn exchanges(tree: &Tree, all: &mut Vec<Edit>) {
    let lines = || {
        let all = tree.lines.iter().enumerate();
        all.filter(|(_, l)| l.is_needed && !l.is_function && &*l.name != "halfway")
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
                let [first, second] = [one, two].map(|line| shown(&line.name));
                let says = format!("{first} and {second} have changed places");
                all.push(Edit { changes, rank: 1, says: Some(says), line: k });
            }
        }
    }
}
