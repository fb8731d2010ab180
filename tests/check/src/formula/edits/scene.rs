use super::places::ORDERS;
use super::{Edit, all_found};
use crate::formula::{Change, Line, Node, Of, Op, Tree, Value};
use glam::DVec3;

/// A number of the scene with other signs, or in another order, or of another thing.
pub(super) fn given(line: &Line, k: usize, all: &mut Vec<Edit>) {
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
            for axes in ORDERS {
                push(which, DVec3::from_array(axes.map(|k| v[k])).into(), 0);
            }
        }
        for other in line.given.iter().filter(|_| 1 < line.given.len()) {
            push(which, other.clone(), 1);
        }
    }
}

/// What may be wrong with the list of objects, or of lights.
pub(super) fn scenes(tree: &Tree, all: &mut Vec<Edit>) {
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
                0,
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
    turned(tree, &mut push);
    if let Some([sum, one, l, n]) = all_found(tree, ["E_s", "G", "l", "n"]) {
        let of = |op: Op, name: usize| Node::of(op, [Node::Name(name)]);
        let cosine = Node::of(Op::Dot, [Node::Name(n), of(Op::Alone(1), l)]);
        let is_lit = Node::of(Op::Less, [Node::Number(0.0), cosine]);
        let [first, last] = [0, 1].map(|which| of(Op::Alone(which), one));
        let changes =
            vec![Change::Line(sum, Node::of(Op::If, [is_lit, last, first]))];
        let says = "the highlights are those of the last light that shines on the point, \
                    not their sum, as with = for +=";
        push("E_s", 0, changes, says.to_owned());
    }
    if let (Some(line), Some(ambient), Some(one)) =
        (tree.find("I"), tree.find("I_a"), tree.find("I_d"))
        && tree.lines[one].is_needed
    {
        let of = |op: Op| Node::of(op, [Node::Name(one)]);
        let product = Node::of(Op::Mul, [Node::Name(ambient), of(Op::Product)]);
        let says =
            "I_a and the I_d of the lights are multiplied, not added".to_owned();
        push("E_d", 0, vec![Change::Line(line, product)], says);
        let most = Node::of(Op::Max, [Node::Name(ambient), of(Op::Most)]);
        let says =
            "I is the larger of I_a and the I_d of the lights, not their sum";
        push("E_d", 0, vec![Change::Line(line, most)], says.to_owned());
        let last = vec![Change::Line(line, of(Op::Alone(1)))];
        let says = "I is the I_d of the last light alone: the ambient part and the first \
                    light are missing";
        push("E_d", 0, last, says.to_owned());
    }
}

/// One object's shape or material for all; and colours that are darker the more they shine.
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
    if let Some([line, g]) = all_found(tree, ["colour'", "g"])
        && let Some(ours) = &tree.lines[line].node
    {
        let shine = Node::of(Op::Chosen, [Node::Name(g)]);
        let rest = Node::of(Op::Sub, [Node::Number(1.0), shine]);
        let node = Node::of(Op::Mul, [ours.clone(), rest]);
        let says =
            "R_a and R_d are what R_s leaves of the colour: colour (1 − R_s)";
        push("colour'", 1, vec![Change::Line(line, node)], says.to_owned());
    }
}

/// Two numbers of one object or of one light that have changed places.
fn turned(tree: &Tree, push: &mut impl FnMut(&str, u8, Vec<Change>, String)) {
    let pairs = [("x_0", "y_0"), ("y_0", "z_0"), ("x_0", "z_0")];
    let fades = [("a'", "b'"), ("b'", "c'"), ("a'", "c'")];
    for (one, two) in pairs.into_iter().chain(fades) {
        let (Some(k), Some(l)) = (tree.find(one), tree.find(two)) else { continue };
        let (of, its) = match one {
            "x_0" | "y_0" => (Of::Object, "its centre"),
            _ => (Of::Light, "a + bd + cd²"),
        };
        for which in 0..tree.count(of) {
            let name = match of {
                Of::Object => tree.object(which),
                _ => ["the warm light", "the cool light"][which],
            };
            let given = |line: usize| tree.lines[line].given[which].clone();
            let changes = vec![
                Change::Given(k, which, given(l)),
                Change::Given(l, which, given(k)),
            ];
            let letters = [one, two].map(|n| n.trim_end_matches(['\'', '0', '_']));
            let says = format!(
                "{} and {} in {its} have changed places, those of {name}",
                letters[0], letters[1]
            );
            push(one, 1, changes, says);
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
                own[0],
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
