use super::{
    Change, Edit, Evidence, Kind, Node, Of, Op, Pixel, Place, Tree, Value, Where,
    batch, edits, kept, misses, solved, spread, unknowns,
};
use crate::measure::{number, vector};
use crate::{Step, each, sort};
use glam::DVec3;
use image::{Rgb, RgbImage};
use std::sync::atomic::Ordering;

/// So much work is enough for one picture: about half a second of two processors. It is
/// counted, not timed, so that an answer is the same on every machine.
const ENOUGH: usize = 320_000_000;

/// Something that is done otherwise than in the lecture, and explains a picture.
#[derive(Clone, Debug)]
pub(crate) struct Cause {
    pub changes: Vec<Change>,
    pub place: Place,
    pub step: Step,
    /// The light, where it concerns one alone.
    pub light: Option<usize>,
    /// Theirs and ours, in words or as formulas.
    pub told: String,
    /// How far-fetched it is.
    pub rank: u8,
    /// Whether it is another formula, not a number or something told in words.
    is_formula: bool,
    /// What tells it from others: its line, or the number of the scene.
    of: String,
}

/// A picture that is to be explained, and the pixels that count.
pub(crate) struct Riddle<'a> {
    pub yours: &'a RgbImage,
    pub samples: u32,
    pub places: &'a [Pixel],
    /// The pixels of our picture.
    pub ours: &'a (dyn Fn(Pixel) -> Rgb<u8> + Sync),
}

impl Riddle<'_> {
    /// Many of the pixels, evenly.
    fn many(&self) -> Vec<Pixel> {
        let rays = self.places.len() * self.samples.pow(2).max(4) as usize;
        // An odd number, as the rows are even: not the same columns again and again.
        let step = (rays / 120_000) | 1;
        self.places.iter().step_by(step).copied().collect()
    }

    /// Those of them that a tree does not explain.
    fn wrong(&self, tree: &Tree) -> Vec<Pixel> {
        misses(tree, self.yours, self.samples, &self.many(), usize::MAX)
    }

    /// The pixels in which the picture is not ours: where these are not few, some.
    fn differing(&self) -> Vec<Pixel> {
        let many = self.many();
        let differing = |places: &[Pixel]| {
            let some = |places: &[Pixel]| {
                Some(kept(places, &mut |place| !self.is_right(place)))
            };
            each(places.chunks(batch(1)).collect(), some).concat()
        };
        let wrong = differing(&many);
        if many.len() < 20 * wrong.len() { wrong } else { differing(self.places) }
    }

    /// Whether a pixel is ours.
    pub fn is_right(&self, (i, j): Pixel) -> bool {
        *self.yours.get_pixel(i, j) == (self.ours)((i, j))
    }

    /// Of some of the wrong pixels, and of others.
    pub fn evidence<'t>(
        &'t self,
        tree: &'t Tree,
        telling: &[Pixel],
        wrong: &[Pixel],
    ) -> Evidence<'t> {
        let (width, height) = self.yours.dimensions();
        let index = |&(i, j): &Pixel| (j * width + i) as usize;
        let mut is_wrong = vec![false; (width * height) as usize];
        wrong.iter().for_each(|place| is_wrong[index(place)] = true);
        // Of these it is known whether they are wrong.
        let mut few = spread(&self.many(), 400, 0);
        // Some of them are close to the wrong ones: outlines end there.
        for &(i, j) in wrong.iter().step_by(wrong.len() / 120 + 1) {
            let by = |k: u32, by: i32| k.saturating_add_signed(by);
            let near = [(7, 0), (-7, 0), (0, 7), (0, -7)];
            let near = near.map(|(u, v)| (by(i, u), by(j, v)));
            few.extend(kept(&near, &mut |(i, j)| {
                i < width && j < height && self.is_right((i, j))
            }));
        }
        let right = kept(&few, &mut |place| !is_wrong[index(&place)]);
        Evidence::new(tree, self.yours, self.samples, telling, &right)
    }

    /// Each single thing that explains every pixel, the likeliest first: one of the edits,
    /// or a number. `wrong` are the pixels that the tree itself does not explain.
    ///
    /// What is not `thorough` leaves out what is far-fetched, and gives up where a number
    /// seems to explain all and does not.
    fn single(
        &self,
        tree: &Tree,
        mut edits: Vec<&Edit>,
        wrong: &[Pixel],
        is_thorough: bool,
    ) -> Vec<Cause> {
        let evidence = self.evidence(tree, wrong, wrong);
        edits.retain(|edit| is_thorough || edit.rank < 2);
        let mut all = survivors(&evidence, edits);
        let is_likely = |cause: &&Cause| cause.rank < 2;
        let is_unlikely = all.iter().find(is_likely).is_none();
        let is_shape = all.iter().filter(is_likely).all(|cause| {
            ["rays", "outlines", "nearest"].contains(&cause.place.stage)
        });
        if is_unlikely || is_shape {
            all.extend(numbers(&evidence, is_unlikely && is_thorough));
        }
        let missed = match self.verified(tree, &mut all) {
            Ok(()) => return all,
            Err(missed) => missed,
        };
        if missed.is_empty() || !is_thorough {
            return vec![];
        }
        // What seemed to explain all did not: then perhaps another number does.
        let few = wrong.iter().step_by(wrong.len() / missed.len().max(100) + 1);
        let telling: Vec<_> = missed.iter().chain(few).copied().collect();
        let evidence = self.evidence(tree, &telling, &telling);
        let mut all = numbers(&evidence, is_unlikely || is_shape);
        self.verified(tree, &mut all).map_or(vec![], |()| all)
    }

    /// Keeps the causes that explain every pixel, the likeliest first, and one of each
    /// line; or returns pixels that the likeliest do not explain.
    fn verified(
        &self,
        tree: &Tree,
        all: &mut Vec<Cause>,
    ) -> Result<(), Vec<Pixel>> {
        sort(all, |cause| {
            // A number of the scene is the likeliest.
            let rank = 2 * usize::from(cause.rank) + usize::from(cause.is_formula);
            [rank, cause.told.chars().count()]
        });
        let mut wrong = vec![];
        // Where much is black or white, many seem to explain it: what the first of them
        // do not explain tells the others.
        let first = all.iter().take(60).enumerate().position(|(k, cause)| {
            if !self.missed(tree, cause, &wrong, 0).is_empty() {
                return false;
            }
            let most = if k < 6 { 2000 } else { 0 };
            let missed = self.missed(tree, cause, self.places, most);
            if k < 6 {
                wrong.extend(missed.iter().step_by(missed.len() / 60 + 1));
            }
            missed.is_empty()
        });
        let Some(first) = first else { return Err(wrong) };
        all.drain(..first);
        self.thin(tree, all);
        Ok(())
    }

    /// The pixels, at most so many, that a cause does not explain.
    fn missed(
        &self,
        tree: &Tree,
        cause: &Cause,
        places: &[Pixel],
        most: usize,
    ) -> Vec<Pixel> {
        let tree = tree.with(&cause.changes);
        misses(&tree, self.yours, self.samples, places, most)
    }

    /// Keeps, beside the first of some causes, those that explain very many pixels, too, and
    /// one of each line.
    fn thin(&self, tree: &Tree, all: &mut Vec<Cause>) {
        let rays = self.places.len() * self.samples.pow(2).max(4) as usize;
        let few = self.places.iter().step_by(rays / 24_000 + 1);
        let few: Vec<_> = few.copied().collect();
        let (mut told, mut tried) = (vec![], 0);
        all.retain(|cause| {
            if 24 <= tried || told.contains(&cause.of) {
                return false;
            }
            tried += 1;
            let fits = tried == 1 || self.missed(tree, cause, &few, 0).is_empty();
            if fits {
                told.push(cause.of.clone());
            }
            fits
        });
    }

    /// The things, one in each group, that explain every pixel together: none where
    /// nothing is wrong, two at most.
    pub fn explained(
        &self,
        tree: &Tree,
        is_thorough: bool,
    ) -> Option<Vec<Vec<Cause>>> {
        let wrong = self.differing();
        if wrong.is_empty() {
            return Some(vec![]);
        }
        let edits = edits(tree);
        let all = edits.iter().collect();
        let single = self.single(tree, all, &wrong, is_thorough);
        if single.is_empty() { None } else { Some(vec![single]) }
    }

    /// Two things that explain every pixel together; or one, where it needs no other.
    pub fn pair(&self, tree: &Tree) -> Option<Vec<Vec<Cause>>> {
        let wrong = self.differing();
        let edits = edits(tree);
        let halves = self.halves(tree, &edits, &wrong);
        for (k, first) in halves.into_iter().enumerate() {
            let work = tree.work.load(Ordering::Relaxed);
            if ENOUGH < work {
                return None; // Not worth the wait.
            }
            let changed = tree.with(&first.changes);
            let rest = self.wrong(&changed);
            if rest.is_empty() {
                // Nothing is left that a second thing could be read from.
                let left =
                    misses(&changed, self.yours, self.samples, self.places, 0);
                if left.is_empty() {
                    return Some(vec![vec![first]]);
                }
                continue;
            }
            let others = apart(&edits, &first);
            let is_thorough = k == 0 && 4 * work < 3 * ENOUGH;
            let second = self.single(&changed, others, &rest, is_thorough);
            let Some(its) = second.first().filter(|second| second.of != first.of)
            else {
                continue;
            };
            // What explains as much as the first, beside the second.
            let changed = tree.with(&its.changes);
            let rest = self.wrong(&changed);
            let evidence = self.evidence(&changed, &rest, &rest);
            let mut others = apart(&edits, its);
            others.retain(|edit| edit.rank < 2);
            let mut firsts = vec![first];
            firsts.extend(survivors(&evidence, others));
            self.thin(&changed, &mut firsts);
            return Some(vec![firsts, second]);
        }
        None
    }
}

/// Those of some edits that are of something else than a cause.
fn apart<'e>(edits: &'e [Edit], cause: &Cause) -> Vec<&'e Edit> {
    let is_other = |one: &Change| cause.changes.iter().all(|two| one.is_apart(two));
    edits.iter().filter(|edit| edit.changes.iter().all(is_other)).collect()
}

/// Those of some edits that explain all pixels of the evidence, and what else does the same.
fn survivors(evidence: &Evidence, edits: Vec<&Edit>) -> Vec<Cause> {
    let tree = evidence.tree;
    let found = evidence.survivors(edits);
    let others = elsewhere(tree, &found);
    let others = evidence.survivors(others.iter().collect());
    found.iter().chain(&others).map(|edit| cause(tree, edit)).collect()
}

/// The numbers that explain all pixels of the evidence: those of the scene, or all.
fn numbers(evidence: &Evidence, has_formulas: bool) -> Vec<Cause> {
    let all = solutions(evidence, has_formulas);
    let others = elsewhere(evidence.tree, &all.iter().collect::<Vec<_>>());
    let others = evidence.survivors(others.iter().collect());
    all.iter().chain(others).map(|edit| cause(evidence.tree, edit)).collect()
}

/// The same, as edits.
pub(super) fn solutions(evidence: &Evidence, has_formulas: bool) -> Vec<Edit> {
    let tree = evidence.tree;
    let mut all = unknowns(tree);
    all.retain(|one| has_formulas || matches!(one.place, Where::Scene(..)));
    each(all, |unknown| {
        let x = solved(evidence, &unknown)?;
        let (change, free) = unknown.change(tree, x);
        let change = match change {
            Change::Line(line, node) => Change::Line(line, filled(&node, &free)),
            other => other,
        };
        let is_put_in = matches!(&change, Change::Line(..)) && unknown.is_colour;
        let is_scene = matches!(unknown.place, Where::Scene(..));
        let rank = if is_put_in { 2 } else { u8::from(!is_scene) };
        Some(Edit { changes: vec![change], rank, says: None, line: unknown.line })
    })
}

/// What the first of some edits do to their lines, done to all others: where one line only
/// passes on what another one has computed, a picture can't tell which it is.
fn elsewhere(tree: &Tree, edits: &[&Edit]) -> Vec<Edit> {
    let mut all = vec![];
    for edit in edits.iter().take(3) {
        let [Change::Line(line, other)] = &edit.changes[..] else { continue };
        let of = &tree.lines[*line];
        let Some(ours) = &of.node else { continue };
        if !other.any(&|node| node == ours) || edit.says.is_some() {
            continue;
        }
        for (k, one) in tree.lines.iter().enumerate() {
            let is_other = k != *line && one.is_needed && one.kind == of.kind;
            let node = one.node.as_ref().filter(|_| is_other && !one.is_function);
            let Some(node) = node else { continue };
            let put_in = |part: &Node| (part == ours).then(|| node.clone());
            let node = other.map(&put_in);
            // It can use only what stands above it, and is of the same thing.
            let is_known = |name: usize| {
                name < k && [Of::Ray, one.of].contains(&tree.lines[name].of)
            };
            if !node.any(&|n| matches!(n, Node::Name(name) if !is_known(*name))) {
                let changes = vec![Change::Line(k, node)];
                all.push(Edit { changes, rank: 3, says: None, line: k });
            }
        }
    }
    all
}

/// An expression with the value in the place of the unknown.
fn filled(node: &Node, free: &Value) -> Node {
    node.map(&|node| match node {
        Node::Free(Kind::Vector) => {
            let three = free.vector(0).to_array().map(Node::Number);
            Some(Node::of(Op::Vector, three))
        }
        Node::Free(_) => Some(Node::Number(free.scalar(0))),
        _ => None,
    })
}

/// An edit with its words.
pub(super) fn cause(tree: &Tree, edit: &Edit) -> Cause {
    let place = tree.lines[edit.line].place;
    let path = place.section.path();
    let told = match (&edit.says, &edit.changes[..]) {
        (Some(says), _) => format!("{says} ({path})"),
        (None, [Change::Given(line, which, value)]) => {
            format!("{} ({path})", given(tree, *line, *which, value))
        }
        (None, changes) => {
            let told = changes.iter().filter_map(|change| match change {
                Change::Line(line, node) => Some((*line, node)),
                _ => None,
            });
            let (theirs, ours): (Vec<_>, Vec<_>) = told
                .map(|(line, node)| {
                    let ours = tree.lines[line].node.as_ref();
                    let ours = ours.map(|node| tree.told(line, node, None));
                    (tree.told(line, node, None), ours.unwrap_or_default())
                })
                .unzip();
            let (theirs, ours) = (theirs.join(" and "), ours.join(" and "));
            format!("{theirs}, where ours is {ours} ({path})")
        }
    };
    let is_one = |change: &Change| match change {
        Change::Given(line, which, _) if tree.lines[*line].of == Of::Light => {
            Some(*which)
        }
        _ => None,
    };
    let place = match &edit.changes[..] {
        [Change::Line(line, node)] if &*tree.lines[*line].name == "I" => {
            Place { stage: term(tree, node).unwrap_or(place.stage), ..place }
        }
        _ => place,
    };
    let lights: Vec<_> = edit.changes.iter().map(is_one).collect();
    let light = lights.first().copied().flatten();
    let light = light.filter(|_| lights.iter().all(|one| *one == light));
    let (changes, step) = (edit.changes.clone(), tree.step);
    let is_line = |change: &Change| matches!(change, Change::Line(..));
    let is_formula = edit.says.is_none() && changes.iter().any(is_line);
    let of = match (&edit.says, &changes[..]) {
        (None, [Change::Given(line, which, _)]) => format!("{line} {which}"),
        (None, [Change::Line(line, _)]) => line.to_string(),
        _ => told.clone(),
    };
    let rank = edit.rank;
    Cause { changes, place, step, light, told, rank, is_formula, of }
}

/// The stage of the one term of a sum that is not simply added.
fn term(tree: &Tree, sum: &Node) -> Option<&'static str> {
    fn added(node: &Node, found: &mut Vec<usize>) {
        match node {
            Node::Name(name) => found.push(*name),
            Node::Of(Op::Add, two) => {
                two.iter().for_each(|node| added(node, found))
            }
            _ => {}
        }
    }
    let mut found = vec![];
    added(sum, &mut found);
    let terms = [("I_a", "ambient"), ("E_d", "diffuse"), ("E_s", "specular")];
    let is_other = |name: &str| {
        let line = tree.find(name).filter(|line| tree.lines[*line].is_needed);
        line.is_some_and(|line| found.iter().filter(|k| **k == line).count() != 1)
    };
    let mut others = terms.iter().filter(|(name, _)| is_other(name));
    let stage = others.next().map(|(_, stage)| *stage);
    stage.filter(|_| others.next().is_none())
}

/// A number of the scene, theirs and ours.
fn given(tree: &Tree, line: usize, which: usize, value: &Value) -> String {
    let one = &tree.lines[line];
    let ours = &one.given[which];
    let text = |value: &Value| match value.is_vector() {
        true => vector(value.vector(0)),
        false => number(value.scalar(0)),
    };
    let object = |k: usize| tree.object(k);
    let light = ["the warm light", "the cool light"][which.min(1)];
    let (yours, ours) = (text(value), text(ours));
    let it = |what: String| {
        format!("{what} is {yours} in your picture; it should be {ours}")
    };
    match (&*one.name, one.of) {
        (axis @ ("x_0" | "y_0" | "z_0"), _) => {
            let part = |name: &str| {
                let line =
                    tree.find(name).map(|k| tree.lines[k].given[which].scalar(0));
                line.unwrap_or(0.0)
            };
            let ours = DVec3::new(part("x_0"), part("y_0"), part("z_0"));
            let mut yours = ours;
            let axis = ["x_0", "y_0", "z_0"].iter().position(|a| *a == axis);
            yours[axis.unwrap_or(0)] = value.scalar(0);
            format!(
                "{} is at {} in your picture; it should be at {}",
                object(which),
                vector(yours),
                vector(ours)
            )
        }
        ("radius''", _) => format!(
            "{} has a radius of {yours} in your picture; it should be {ours}",
            object(which)
        ),
        ("colour", _) => it(format!("the colour of {}", object(which))),
        ("g", _) => it(format!("R_s of {}", object(which))),
        ("n''", _) => format!(
            "the highlights of {} are those of n = {yours}; it should be {ours}",
            object(which)
        ),
        ("P", _) => {
            format!("{light} is at {yours} in your picture; it should be at {ours}")
        }
        (name, Of::Light) if name.ends_with('\'') => {
            it(format!("{light}'s {} in a + bd + cd²", super::shown(name)))
        }
        (name, Of::Light) => it(format!("{light}'s {name}")),
        (name, _) => it(super::shown(name)),
    }
}
