//! Where one thing does not explain a picture: the one of two to begin with.

use super::explain::{cause, solutions};
use super::{
    Cause, Change, Context, Edit, Evidence, Part, Pixel, Riddle, Tree, Values,
    batch, kept, spread,
};
use crate::measure::sky;
use crate::{Step, each, sort};
use glam::DVec3;

impl Riddle<'_> {
    /// Single things that mend some of the pixels that are wrong, or bring them nearer, and
    /// leave most of the others right: the best of each line.
    pub fn halves(
        &self,
        tree: &Tree,
        edits: &[Edit],
        wrong: &[Pixel],
    ) -> Vec<Cause> {
        let few = spread(self.places, 1000, 0);
        let sky = self.of_sky(tree, edits, &few);
        if !sky.is_empty() {
            let sky = sky.iter().take(8).map(|edit| (edit, 0)).collect();
            return self.nearest(tree, sky, wrong, 3);
        }
        let dark = self.of_dark(tree, edits);
        if !dark.is_empty() {
            let dark = dark.iter().map(|edit| (edit, 0)).collect();
            return self.nearest(tree, dark, wrong, 3);
        }
        // Where little is right, that is by chance.
        let right = kept(&few, &mut |place| self.is_right(place)).len();
        let may_spoil = 10 * right < few.len();
        let groups = self.groups(tree, &spread(wrong, 2000, 0));
        let some = |(_, all): &Group| spread(all, 24, 0);
        let mut telling: Vec<_> = groups.iter().flat_map(some).collect();
        telling.extend(spread(wrong, telling.len(), 0));
        let evidence = self.evidence(tree, &telling, wrong);
        let numbers = self.of_places(tree, &groups, wrong);
        let likely = edits.iter().filter(|edit| edit.rank < 2);
        let all = likely.chain(&numbers).collect();
        // The first is nearly always one of the two, if any is.
        let most = if tree.step == Step::Rays { 12 } else { 4 };
        let group = |place: &Pixel| {
            let its = groups.iter().position(|(_, all)| all.contains(place));
            its.unwrap_or(groups.len())
        };
        let groups = evidence.parts[3]
            .wrong
            .iter()
            .map(|(all, _)| all.iter().map(group).collect::<Vec<_>>());
        let groups = groups.collect::<Vec<_>>().concat();
        let best = best(&evidence, all, may_spoil, &groups);
        self.nearest(tree, best, wrong, most)
    }

    /// The numbers of the scene that explain one place each, where one object is seen.
    fn of_places(
        &self,
        tree: &Tree,
        groups: &[Group],
        wrong: &[Pixel],
    ) -> Vec<Edit> {
        let reach = self.yours.width() / 12;
        let near = |all: &[Pixel], &(i, j): &Pixel| {
            kept(all, &mut |(u, v)| i.abs_diff(u).max(j.abs_diff(v)) < reach)
        };
        let objects = || groups.iter().filter(|(key, _)| SKY < *key);
        let most = 3_u32.div_ceil(self.samples) as usize;
        // Ambient light alone tells of its numbers best.
        let is_dark = |(key, _): &&Group| key % 4 == 0 && self.samples < 3;
        let dark = objects().skip(most).filter(is_dark).take(3);
        let mut numbers = vec![];
        for (k, (key, group)) in objects().take(most).chain(dark).enumerate() {
            // One place of it: there, nothing else hides it.
            let centres = spread(group, 9, 0);
            let centre = centres.iter().max_by_key(|at| near(group, at).len());
            let place = centre.map_or(vec![], |at| near(wrong, at));
            let mut parts = self.groups(tree, &place).into_iter();
            let place = parts.find(|(other, _)| other == key);
            let Some((_, place)) = place.filter(|(_, place)| 8 < place.len())
            else {
                continue;
            };
            let its = solutions(&self.evidence(tree, &place, wrong), false);
            let is_told = most <= k && !its.is_empty();
            numbers.extend(its);
            if is_told {
                break;
            }
        }
        numbers
    }

    /// Those of some edits that bring the picture nearest, one of each line; more pixels
    /// tell which they are. Each comes with how many pixels it mends in groups of which it
    /// mends all.
    fn nearest(
        &self,
        tree: &Tree,
        all: Vec<(&Edit, usize)>,
        wrong: &[Pixel],
        most: usize,
    ) -> Vec<Cause> {
        let rays = (self.samples * self.samples) as usize;
        let mut some = spread(wrong, 1800 / rays, 0);
        some.extend(spread(self.places, 400 / rays, 0));
        let rated = |(edit, whole): (&Edit, usize)| {
            let half = cause(tree, edit);
            let [far, missed] = self.left(&tree.with(&edit.changes), &some);
            let far_of_whole = if whole == 0 { far + MANY } else { far };
            Some(([far_of_whole, far, missed], half, edit.line))
        };
        let mut all = each(all, rated);
        let (mut lines, mut halves) = (vec![], vec![]);
        // What mends whole groups, what leaves the least, what mends the most.
        let order = [0, 1, 0, 2];
        for k in 0..all.len().min(most) {
            let of = order[k % order.len()];
            sort(&mut all, |(left, half, line)| {
                let told = half.told.chars().count();
                let is_taken = usize::from(lines.contains(line));
                // A little nearer is so by chance.
                let left = left[of] + left[of] / 20 * usize::from(half.rank);
                [is_taken << 30 | left, told]
            });
            let (_, half, line) = all.remove(0);
            if !lines.contains(&line) {
                lines.push(line);
                halves.push(half);
            }
        }
        halves
    }

    /// The edits, or else the numbers, that explain the sky of a picture, where that is
    /// another than ours.
    fn of_sky(&self, tree: &Tree, edits: &[Edit], few: &[Pixel]) -> Vec<Edit> {
        // What is sky in both.
        let all = self.sees_none(tree, &sky(self.yours, few));
        let sky = kept(&all, &mut |place| !self.is_right(place));
        if sky.len() < 60 || sky.len() * 4 < all.len() * 3 {
            return vec![];
        }
        // There, one ray has the mean of all.
        let evidence = Evidence::new(tree, self.yours, 1, &sky, &[]);
        let mut all = evidence.survivors(edits.iter().collect());
        if all.is_empty() {
            let numbers = solutions(&evidence, true);
            if !numbers.is_empty() {
                return numbers;
            }
            all = firsts(&evidence, edits);
        }
        all.into_iter().cloned().collect()
    }

    /// How far some pixels are from what a tree makes, and how many of them are it not.
    fn left(&self, tree: &Tree, some: &[Pixel]) -> [usize; 2] {
        let context = Context::plain(tree);
        let (mut bits, mut missed) = (0, 0);
        for places in some.chunks(batch(self.samples)) {
            let values = Values::at(tree, places, self.samples);
            let pixels = values.changed(&context).pixels();
            for (&(i, j), pixel) in places.iter().zip(pixels) {
                let far = far(self.yours.get_pixel(i, j).0, pixel);
                bits += far;
                missed += usize::from(0 < far);
            }
        }
        [bits, missed]
    }

    /// Those of some pixels that see no object.
    pub(super) fn sees_none(&self, tree: &Tree, few: &[Pixel]) -> Vec<Pixel> {
        let mut none = vec![];
        for (key, its) in self.groups(tree, few) {
            if key <= SKY {
                none.extend(its);
            }
        }
        none
    }

    /// Some of the wrong pixels, by the object that is seen and the lights that reach it;
    /// the largest group first.
    pub(super) fn groups(&self, tree: &Tree, few: &[Pixel]) -> Vec<Group> {
        let (context, diffuse) = (Context::plain(tree), tree.find("I_d"));
        let diffuse = diffuse.filter(|line| tree.lines[*line].is_needed);
        let mut groups: Vec<Group> = vec![];
        for places in few.chunks(batch(1)) {
            let values = Values::at(tree, places, 1);
            let values = values.changed(&context);
            for (k, place) in places.iter().enumerate() {
                let object = values.name(tree.nearest, 0).scalar(k);
                let mut key = (1.0 + object) as usize;
                for light in 0..2 {
                    let is_lit =
                        |line| values.name(line, light).vector(k) != DVec3::ZERO;
                    key = 2 * key + usize::from(diffuse.is_some_and(is_lit));
                }
                match groups.iter_mut().find(|(other, _)| *other == key) {
                    Some((_, group)) => group.push(*place),
                    None => groups.push((key, vec![*place])),
                }
            }
        }
        sort(&mut groups, |(_, group)| [usize::MAX - group.len(), 0]);
        groups
    }
}

/// Pixels that see one object which the same lights reach, and what tells these: 0 and 1
/// for the lights in its last two bits.
pub(super) type Group = (usize, Vec<Pixel>);

/// The last key of what sees no object.
const SKY: usize = 3;

/// How far a pixel is from another: about as many bits as it takes to tell it from that.
fn far(yours: [u8; 3], other: [u8; 3]) -> usize {
    let bits = |k: usize| {
        let off = 1 + u32::from(yours[k].abs_diff(other[k]));
        // In quarters of a bit, by the line between two powers.
        let whole = off.ilog2();
        let bits = 4 * whole + ((4 * off) >> whole) - 4;
        counted(yours[k], bits as usize)
    };
    (0..3).map(bits).sum()
}

/// How much a difference counts: that of a byte at an end is less, as much ends there by
/// chance.
fn counted(yours: u8, off: usize) -> usize {
    if matches!(yours, 0 | 255) { off / 4 } else { off }
}

/// Farther than all pixels are together.
const MANY: usize = 1 << 24;

/// What becomes of the wrong pixels with an edit.
struct Rated {
    /// Which it is.
    edit: usize,
    /// How many it mends.
    mended: usize,
    /// Those of them that are in groups of which it mends all.
    whole: usize,
    /// How far they all still are.
    far: usize,
    after: Vec<[u8; 3]>,
}

impl Rated {
    /// None where it spoils a third of those that are right, unless it may.
    fn of(
        evidence: &Evidence,
        may_spoil: bool,
        part: &Part,
        groups: &[usize],
        edit: usize,
        changes: &[Change],
    ) -> Option<Self> {
        let context = Context::new(evidence.tree, changes, 0.0.into());
        let (mut rights, mut spoilt) = (0, 0);
        for (places, values) in &part.right {
            for (place, p) in places.iter().zip(values.changed(&context).pixels()) {
                rights += 1;
                spoilt += usize::from(!evidence.is_right(part, *place, p));
            }
        }
        // Some are right by chance, as where bytes are cut off, or where few are.
        if !may_spoil && rights + 16 < 3 * spoilt {
            return None;
        }
        let (mut mended, mut far, mut after) = (0, 0, vec![]);
        // Of each group, how many it mends, and how many it does not.
        let mut both = vec![[0; 2]; groups.iter().max().map_or(0, |most| most + 1)];
        for (places, values) in &part.wrong {
            for (place, p) in places.iter().zip(values.changed(&context).pixels()) {
                let is_right = evidence.is_right(part, *place, p);
                mended += usize::from(is_right);
                let yours = evidence.pixel(*place);
                // Bytes at an end are right by chance.
                let is_clear = yours.iter().all(|byte| !matches!(byte, 0 | 255));
                if let Some(group) = groups.get(after.len()).filter(|_| is_clear) {
                    both[*group][usize::from(!is_right)] += 1;
                }
                for k in 0..3 {
                    let off = usize::from(yours[k].abs_diff(p[k]));
                    far += counted(yours[k], off);
                }
                after.push(p);
            }
        }
        let whole =
            both.iter().filter(|[right, wrong]| 5 < *right && 8 * wrong < *right);
        let whole = whole.map(|[right, _]| right).sum();
        Some(Self { edit, mended, whole, far, after })
    }
}

/// The first of two slips of the hand that explain all pixels of the sky together.
fn firsts<'e>(evidence: &Evidence, edits: &'e [Edit]) -> Vec<&'e Edit> {
    let few = &evidence.parts[1];
    let rated = |edit: &'e Edit| {
        let rated = Rated::of(evidence, true, few, &[], 0, &edit.changes)?;
        let hash = |hash: usize, byte: &u8| {
            (hash ^ usize::from(*byte)).wrapping_mul(16_777_619)
        };
        Some((edit, rated.after.as_flattened().iter().fold(0, hash)))
    };
    let is_slip = |edit: &&Edit| {
        let stage = evidence.tree.lines[edit.line].place.stage;
        // Another angle is an option, more likely.
        let is_angle = ["θ", "h"].contains(&&*evidence.tree.lines[edit.line].name);
        edit.rank == 0 && !is_angle && ["rays", "sky", "sum"].contains(&stage)
    };
    let mut all = each(edits.iter().filter(is_slip).collect(), rated);
    // One of those that make the same pixels.
    sort(&mut all, |(_, hash)| [*hash, 0]);
    all.dedup_by_key(|(_, hash)| *hash);
    let with_another = |k: usize| {
        let first = all[k].0;
        let fits = |(second, _): &(&Edit, usize)| {
            let two = [&first.changes[..], &second.changes].concat();
            first.line != second.line && evidence.fits(&two, 0.0.into())
        };
        all[k + 1..].iter().any(fits).then_some(first)
    };
    each((0..all.len()).collect(), with_another)
}

/// The edits that mend most, and those that bring nearest.
fn best<'e>(
    evidence: &Evidence,
    edits: Vec<&'e Edit>,
    may_spoil: bool,
    groups: &[usize],
) -> Vec<(&'e Edit, usize)> {
    let [_, few, more, most] = &evidence.parts;
    let rated = |part: &Part, groups: &[usize], all: Vec<usize>| {
        let one = |k: usize| {
            Rated::of(evidence, may_spoil, part, groups, k, &edits[k].changes)
        };
        each(all, one)
    };
    let same = |part: &Part| Rated::of(evidence, may_spoil, part, &[], 0, &[]);
    let (Some(few_same), Some(most_same)) = (same(few), same(most)) else {
        return vec![];
    };
    // Most change none of a few pixels, or spoil them.
    let mut all = rated(few, &[], (0..edits.len()).collect());
    all.retain(|one| 0 < one.mended || one.far < few_same.far);
    let all = all.iter().map(|one| one.edit).collect();
    // Some seem good to few pixels; many tell.
    let some = first(&edits, &mut rated(more, &[], all), 120, 3);
    let mut all = rated(most, groups, some);
    all.retain(|one| {
        most_same.after.len() / 16 < one.mended
            || 0 < one.whole
            || 3 * one.far < 2 * most_same.far
    });
    let first = first(&edits, &mut all, 22, 2).into_iter();
    let whole =
        |k: usize| all.iter().find(|one| one.edit == k).map_or(0, |one| one.whole);
    first.map(|k| (edits[k], whole(k))).collect()
}

/// The first of those that mend most and of those that bring nearest, in their order; of
/// what makes the same pixels in one line, only some.
fn first(
    edits: &[&Edit],
    all: &mut [Rated],
    most: usize,
    alike: usize,
) -> Vec<usize> {
    let mut first = vec![];
    for by in 0..3 {
        sort(all, |one| {
            let mended = usize::MAX - one.mended;
            match by {
                0 => [mended, one.far],
                1 => [one.far, mended],
                _ => [usize::MAX - one.whole, mended],
            }
        });
        let mut taken = vec![];
        for one in &*all {
            let this = (edits[one.edit].line, &one.after);
            let same = taken.iter().filter(|other| **other == this).count();
            if taken.len() < most && same < alike {
                taken.push(this);
                first.push(one.edit);
            }
        }
    }
    sort(&mut first, |k| [*k, 0]);
    first.dedup();
    first
}
