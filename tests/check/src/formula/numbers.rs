use super::{
    Change, Context, Evidence, Kind, Known, Node, Of, Op, Part, Tree, Value, Values,
};
use crate::sort;
use glam::DVec3;
use std::f64::consts::PI;

/// A number that may be another one, and the values to begin with.
#[derive(Clone, Debug)]
pub(crate) struct Unknown {
    /// The line that it belongs to.
    pub line: usize,
    /// Whether it is one number each for red, green and blue.
    pub is_colour: bool,
    pub place: Where,
    /// Ours; 1 for a factor or a power that is put in, 0 for what is added.
    pub ours: DVec3,
}

/// Where an unknown number stands.
#[derive(Clone, Debug)]
pub(crate) enum Where {
    /// In the scene: of this object or light, all of a vector or one part of it.
    Scene(usize, Option<usize>),
    /// In a formula.
    Formula(Node),
}

impl Unknown {
    /// The change that gives it this value.
    pub fn change(&self, tree: &Tree, value: DVec3) -> (Change, Value) {
        let line = &tree.lines[self.line];
        let free: Value = match self.is_colour {
            true => value.into(),
            false => value.x.into(),
        };
        let change = match &self.place {
            Where::Formula(node) => Change::Line(self.line, node.clone()),
            Where::Scene(which, None) => {
                Change::Given(self.line, *which, free.clone())
            }
            Where::Scene(which, Some(part)) => {
                let mut whole = line.given[*which].vector(0);
                whole[*part] = value.x;
                Change::Given(self.line, *which, whole.into())
            }
        };
        (change, free)
    }
}

/// Every number of the scene and of the formulas, and those that may be put in.
pub(crate) fn unknowns(tree: &Tree) -> Vec<Unknown> {
    let mut all = vec![];
    for (line, one) in tree.lines.iter().enumerate().filter(|(_, l)| l.is_needed) {
        match &one.node {
            None if one.of == Of::Ray && &*one.name != "L_a" => {}
            None => scene(tree, line, &mut all),
            Some(node) => {
                let mut push = |place: Node, is_colour: bool, ours: f64| {
                    let (place, ours) = (Where::Formula(place), DVec3::splat(ours));
                    all.push(Unknown { line, is_colour, place, ours });
                };
                holes(node, &mut |node, ours| push(node, false, ours));
                if one.of == Of::Light {
                    letters(tree, node, &mut |node| push(node, false, 1.0));
                }
                put_in(tree, line, node, &mut push);
            }
        }
    }
    all
}

fn scene(tree: &Tree, line: usize, all: &mut Vec<Unknown>) {
    let is_colour =
        ["colour", "L_d", "L_s", "L_a"].contains(&&*tree.lines[line].name);
    for (which, value) in tree.lines[line].given.iter().enumerate() {
        let ours = value.vector(0);
        let parts: &[Option<usize>] = match (value.is_vector(), is_colour) {
            (true, false) => &[Some(0), Some(1), Some(2)],
            _ => &[None],
        };
        if &*tree.lines[line].name != "number" {
            all.extend(parts.iter().map(|&part| Unknown {
                line,
                is_colour,
                place: Where::Scene(which, part),
                ours: part.map_or(ours, |part| DVec3::splat(ours[part])),
            }));
        }
    }
}

/// The expression with each of its numbers unknown in turn.
fn holes(node: &Node, push: &mut dyn FnMut(Node, f64)) {
    match node {
        Node::Number(ours) if ours.is_finite() => {
            push(Node::Free(Kind::Scalar), *ours)
        }
        Node::Of(op, nodes) => {
            for (k, below) in nodes.iter().enumerate() {
                holes(below, &mut |other, ours| {
                    let mut nodes = nodes.clone();
                    nodes[k] = other;
                    push(Node::Of(*op, nodes), ours);
                });
            }
        }
        _ => {}
    }
}

/// The expression with a number in the place of each of its scalars in turn.
fn letters(tree: &Tree, node: &Node, push: &mut dyn FnMut(Node)) {
    match node {
        Node::Name(name) if tree.lines[*name].kind == Kind::Scalar => {
            push(Node::Free(Kind::Scalar));
        }
        Node::Of(op, nodes) => {
            for (k, below) in nodes.iter().enumerate() {
                letters(tree, below, &mut |other| {
                    let mut nodes = nodes.clone();
                    nodes[k] = other;
                    push(Node::Of(*op, nodes));
                });
            }
        }
        _ => {}
    }
}

/// A factor, a power, a term or a bound for the whole line, or one colour in its place.
fn put_in(
    tree: &Tree,
    line: usize,
    node: &Node,
    push: &mut dyn FnMut(Node, bool, f64),
) {
    let (name, kind) = (&*tree.lines[line].name, tree.lines[line].kind);
    let is_light = [
        "R_a", "I_a", "R_d", "I_d", "R_s", "I_s", "E_d", "E_s", "I", "M", "sky",
        "colour'",
    ];
    let is_light = is_light.contains(&name);
    if ["nearest", "order", "I'", "pixel", "G", "S", "C", "v''"].contains(&name) {
        return;
    }
    let with = |op: Op, kind: Kind| Node::of(op, [node.clone(), Node::Free(kind)]);
    push(with(Op::Mul, Kind::Scalar), false, 1.0);
    if ["R_a", "R_d", "R_s"].contains(&name) {
        push(Node::Free(Kind::Vector), true, 0.5);
    }
    if is_light {
        push(with(Op::Mul, Kind::Vector), true, 1.0);
        push(with(Op::Min, Kind::Scalar), false, 1.0);
        push(with(Op::Pow, Kind::Scalar), false, 1.0);
    }
    if is_light || kind == Kind::Scalar {
        push(with(Op::Add, Kind::Scalar), false, 0.0);
    }
}

/// How far off some pixels are, for each channel; or something that is no less than
/// `most`.
fn cost(
    evidence: &Evidence,
    part: &Part,
    unknown: &Unknown,
    x: DVec3,
    most: DVec3,
) -> DVec3 {
    let (change, free) = unknown.change(evidence.tree, x);
    let changes = [change];
    let context = Context::new(evidence.tree, &changes, free);
    let mut cost = DVec3::ZERO;
    for (places, values) in part.all() {
        for (place, pixel) in places.iter().zip(values.changed(&context).pixels()) {
            let yours = evidence.pixel(*place);
            let apart = |k: usize| {
                let apart = yours[k].abs_diff(pixel[k]);
                f64::from(apart.saturating_sub(part.slack).min(24))
            };
            let apart = DVec3::from_array([0, 1, 2].map(apart));
            cost += match unknown.is_colour {
                true => apart,
                false => DVec3::splat(apart.element_sum()),
            };
        }
        if cost.cmpge(most).all() {
            break;
        }
    }
    cost
}

/// How many of some pixels become another one with none of these values.
fn unreached(
    evidence: &Evidence,
    values: &Values,
    unknown: &Unknown,
    some: &[DVec3],
) -> usize {
    let pixels = |changes: &[Change], free: Value| {
        let context = Context::new(evidence.tree, changes, free);
        values.changed(&context).pixels()
    };
    let ours = pixels(&[], 0.0.into());
    let mut is_left = vec![true; ours.len()];
    for x in some {
        let (change, free) = unknown.change(evidence.tree, *x);
        let both = pixels(&[change], free).into_iter().zip(&ours);
        for (left, (pixel, ours)) in is_left.iter_mut().zip(both) {
            *left &= pixel == *ours;
        }
        if !is_left.contains(&true) {
            return 0;
        }
    }
    is_left.into_iter().filter(|is_left| *is_left).count()
}

/// A value for each of the channels, and what it costs.
#[derive(Clone, Copy, Debug)]
struct Best {
    cost: DVec3,
    x: DVec3,
}

impl Best {
    fn take(&mut self, cost: DVec3, x: DVec3) {
        let is_less = cost.cmplt(self.cost);
        self.x = DVec3::select(is_less, x, self.x);
        self.cost = DVec3::select(is_less, cost, self.cost);
    }
}

/// The value of an unknown that explains the few pixels of the evidence, if there is
/// one; it is as round as it may be.
pub(crate) fn solved(evidence: &Evidence, unknown: &Unknown) -> Option<DVec3> {
    let ours = unknown.ours;
    let name = &*evidence.tree.lines[unknown.line].name;
    let is_shape = ["x_0", "y_0", "z_0", "radius''"].contains(&name);
    let some = [-1.0, 0.0, 0.5, 2.0].map(|k| k * ours);
    let far = if name == "radius''" { 1.0 } else { 6.0 };
    let more = [0.3, -1.0, far, -far].map(|k| ours + k);
    let some: Vec<_> = some.into_iter().chain(more).collect();
    let [fewest, few, more, most] = evidence.parts.each_ref();
    let unreached = |known: &Known, some: &[DVec3]| {
        unreached(evidence, &known.1, unknown, some)
    };
    let mut left = 0;
    let is_hopeful = match is_shape {
        // A sphere changes some of what is wrong by not being there, or most of it elsewhere.
        true => {
            let gone = if name == "radius''" { 0.0 } else { 1e9 };
            let gone = [DVec3::splat(gone)];
            more.wrong.iter().all(|known| {
                let all = known.0.len();
                5 * unreached(known, &gone) <= 4 * all
                    || 5 * unreached(known, &some) <= all
            })
        }
        // Another number changes all of it, but for what is wrong by a rounding.
        false => fewest.wrong.iter().chain(&more.wrong).all(|known| {
            left += unreached(known, &some);
            left <= 1 + known.0.len() / 8
        }),
    };
    if !is_hopeful {
        return None;
    }
    let start = cost(evidence, more, unknown, ours, DVec3::INFINITY);
    let mut best = Best { cost: start, x: ours };
    let factors = [
        -1.0, 0.0, 0.01, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.2, 1.5, 2.0, 3.0, 5.0,
        10.0, 100.0,
    ];
    let terms = [0.1, 0.25, 0.5, 1.0, 3.0, 6.0, 10.0];
    let mut terms = terms.to_vec();
    if is_shape {
        terms.extend((1..24).map(|k| 0.2 * f64::from(k)));
    } else if ours == DVec3::ZERO {
        // What is nothing with us has no factors.
        terms.extend([0.002, 0.02, 0.75, 0.9, 2.0, 4.0, 5.0, 8.0]);
    }
    let mut others = factors.map(|k| k * ours).to_vec();
    for x in terms.iter().flat_map(|k| [ours + *k, ours - *k]) {
        let is_near = |other: &DVec3| {
            (x - other).abs().max_element() < 0.04 * x.abs().max_element()
        };
        if is_shape || !others.iter().any(is_near) {
            others.push(x);
        }
    }
    // Of one number, those that are best for few pixels.
    if !unknown.is_colour {
        let sum = |x| cost(evidence, few, unknown, x, DVec3::INFINITY).x;
        let start = sum(ours);
        let mut rated: Vec<_> = others.iter().map(|x| (sum(*x), *x)).collect();
        rated.retain(|(cost, _)| *cost < 0.9 * start);
        sort(&mut rated, |(cost, _)| [*cost as usize, 0]);
        rated.truncate(if is_shape { 20 } else { 6 });
        others = rated.into_iter().map(|(_, x)| x).collect();
    }
    let mut shapes = vec![];
    for x in others {
        let enough = if is_shape { 0.5 * start } else { best.cost };
        let cost = cost(evidence, more, unknown, x, enough);
        if is_shape && cost.cmplt(0.5 * start).all() {
            shapes.push(Best { cost, x });
        }
        best.take(cost, x);
    }
    // Of 800 numbers that were found, a sphere's was at a quarter of this cost by then, and
    // another's at three quarters at most.
    let is_lost = |best: &Best, share: f64| (share * start).cmplt(best.cost).all();
    if is_lost(&best, if is_shape { 0.5 } else { 0.8 }) {
        // A number of the rays moves outlines at once, be it nearly right.
        if evidence.tree.lines[unknown.line].of != Of::Ray || unknown.is_colour {
            return None;
        }
        refine(evidence, more, unknown, &mut best, 0.02);
    }
    refine(evidence, more, unknown, &mut best, 0.35);
    if is_lost(&best, 0.5) {
        return None;
    }
    // A small sphere is found from near by alone.
    for mut other in near(&shapes) {
        if best.cost == DVec3::ZERO {
            break;
        }
        refine(evidence, more, unknown, &mut other, 0.05);
        best.take(other.cost, other.x);
    }
    let few = more.all().map(|known| known.0.len()).sum::<usize>() as f64;
    if 3.0 * few < best.cost.max_element() {
        return None;
    }
    let centre = best.x;
    best.cost = cost(evidence, most, unknown, best.x, DVec3::INFINITY);
    // A bound parts the pixels: no slope leads to it.
    let is_bound =
        matches!(&unknown.place, Where::Formula(node) if has_bound(node));
    let many = most.all().map(|known| known.0.len()).sum::<usize>() as f64;
    if many * if is_bound { 6.0 } else { 4.0 } < best.cost.max_element() {
        return None;
    }
    // Where it can't be seen, many places are alike for few pixels.
    for one in shapes.iter().filter(|one| one.cost == DVec3::ZERO) {
        best.take(cost(evidence, most, unknown, one.x, best.cost), one.x);
    }
    refine(evidence, most, unknown, &mut best, if is_shape { 0.2 } else { 0.04 });
    if is_bound {
        refine(evidence, most, unknown, &mut best, 0.35);
    }
    if is_shape && best.cost != DVec3::ZERO {
        scan(evidence, most, unknown, &mut best, centre);
    }
    if best.cost != DVec3::ZERO {
        return None;
    }
    rounded(evidence, unknown, best.x)
}

/// Whether something is compared with the unknown number.
fn has_bound(node: &Node) -> bool {
    let Node::Of(op, nodes) = node else { return false };
    let compares = matches!(op, Op::Less | Op::LessOrEqual | Op::Max | Op::Min);
    let is_free = |node: &Node| matches!(node, Node::Free(_));
    compares && nodes.iter().any(is_free) || nodes.iter().any(has_bound)
}

/// Looks around the best value, in smaller and smaller steps, and at round numbers.
fn refine(
    evidence: &Evidence,
    part: &Part,
    unknown: &Unknown,
    best: &mut Best,
    share: f64,
) {
    let mut step = (share * best.x.abs()).max(DVec3::splat(share * 0.3));
    for _ in 0..20 {
        if best.cost == DVec3::ZERO {
            break;
        }
        let x = best.x;
        for x in [x - step, x + step] {
            best.take(cost(evidence, part, unknown, x, best.cost), x);
        }
        step *= 0.6;
    }
    for scale in [1.0, 10.0, 100.0] {
        let round = (best.x * scale).round() / scale;
        best.take(cost(evidence, part, unknown, round, best.cost), round);
    }
}

/// The best values for a sphere, one of each cost.
fn near(all: &[Best]) -> impl Iterator<Item = Best> {
    let mut all = all.to_vec();
    sort(&mut all, |one| [one.cost.x as usize, 0]);
    all.dedup_by_key(|one| one.cost.x);
    all.into_iter().take(6)
}

/// Looks at the round numbers around the best value and another one: an outline of flat
/// colours is no slope that leads to the right one.
fn scan(
    evidence: &Evidence,
    part: &Part,
    unknown: &Unknown,
    best: &mut Best,
    other: DVec3,
) {
    for centre in [best.x, other] {
        let hundredth =
            |k: i32| (centre * 100.0).round() / 100.0 + f64::from(k) / 100.0;
        for x in (0..8).flat_map(|k| [hundredth(k), hundredth(-k)]) {
            best.take(cost(evidence, part, unknown, x, best.cost), x);
        }
    }
}

/// The value of the fewest digits that explains all pixels of the evidence.
fn rounded(evidence: &Evidence, unknown: &Unknown, x: DVec3) -> Option<DVec3> {
    let is_it = |x: DVec3| {
        x.is_finite()
            && evidence.parts.iter().all(|part| {
                cost(evidence, part, unknown, x, DVec3::splat(1.0)) == DVec3::ZERO
            })
    };
    let digits = |digits: i32| {
        x.map(|x| {
            let scale = 10_f64.powi(digits);
            (x * scale).round() / scale
        })
    };
    // Each channel by itself: one may need more digits than another.
    let mut rounds = (0..3).map(digits).collect::<Vec<_>>();
    rounds.extend([x.map(constant), digits(3)]);
    // One over a number of two digits, as of gamma.
    rounds.push(x.map(|x| 10.0 / (10.0 / x).round()));
    rounds.extend((4..6).map(digits));
    rounds.push(x);
    if !unknown.is_colour {
        return rounds.into_iter().find(|x| is_it(*x));
    }
    let mut best = x;
    for k in 0..3 {
        let with = |value: f64| {
            let mut other = best;
            other[k] = value;
            other
        };
        let round = rounds.iter().map(|x| with(x[k])).find(|x| is_it(*x));
        best = round.unwrap_or(best);
    }
    is_it(best).then_some(best)
}

/// The simple fraction, perhaps of π, that is very near; or else no number.
fn constant(x: f64) -> f64 {
    let simple = [1.0, 2.0, 4.0, 180.0];
    let of_pi = simple.into_iter().flat_map(|k| [k * PI, PI / k, k / PI]);
    let thirds = (1..12).flat_map(|k| [3.0, 7.0, 9.0].map(|by| f64::from(k) / by));
    let near = |one: &f64| (x.abs() - one).abs() < 1e-3 * one;
    let found = of_pi.chain(thirds).find(near);
    found.map_or(f64::NAN, |one| one.copysign(x))
}
