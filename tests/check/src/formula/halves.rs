//! Where one thing does not explain a picture: the one of two to begin with.

use super::explain::{cause, solutions};
use super::{
    Cause, Change, Context, Edit, Evidence, Part, Pixel, Riddle, SOME, Tree,
    Values, kept, spread,
};
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
        let groups = self.groups(tree, wrong);
        let few = |all: &Vec<Pixel>| spread(all, 24, 0);
        let mut telling: Vec<_> = groups.iter().flat_map(few).collect();
        telling.extend(spread(wrong, telling.len(), 0));
        let evidence = self.evidence(tree, &telling, wrong);
        let mut numbers = vec![];
        let reach = self.yours.width() / 12;
        for group in groups.iter().take(3) {
            // One place of it: there, nothing else hides it.
            let near = |&(i, j): &Pixel| {
                kept(group, &mut |(u, v)| i.abs_diff(u).max(j.abs_diff(v)) < reach)
            };
            let centres = spread(group, 9, 0);
            let place = centres.iter().map(near).max_by_key(Vec::len);
            let place = place.unwrap_or_default();
            if 8 < place.len() {
                numbers
                    .extend(solutions(&self.evidence(tree, &place, wrong), false));
            }
        }
        // More pixels tell which of them are best, one of each line.
        let rays = (self.samples * self.samples) as usize;
        let mut some = spread(wrong, 3000 / rays, 0);
        some.extend(spread(self.places, 600 / rays, 0));
        let rated = |edit: &Edit| {
            let half = cause(tree, edit);
            let left = self.left(&tree.with(&edit.changes), &some);
            Some((left, half, edit.line))
        };
        let likely = edits.iter().filter(|edit| edit.rank < 2);
        let all = likely.chain(&numbers).collect();
        let mut all = each(best(&evidence, all), rated);
        // The first is nearly always one of the two, if any is.
        let most = if tree.step == Step::Rays { 12 } else { 4 };
        let (mut lines, mut halves) = (vec![], vec![]);
        // What leaves the least; the second is what mends the most.
        for k in 0..all.len().min(most) {
            let of = usize::from(k == 1);
            sort(&mut all, |(left, half, line)| {
                let told = half.told.chars().count();
                let is_taken = usize::from(lines.contains(line));
                [is_taken << 30 | left[of], 1000 * usize::from(half.rank) + told]
            });
            let (_, half, line) = all.remove(0);
            if !lines.contains(&line) {
                lines.push(line);
                halves.push(half);
            }
        }
        halves
    }

    /// How far some pixels are from what a tree makes, and how many of them are it not.
    fn left(&self, tree: &Tree, some: &[Pixel]) -> [usize; 2] {
        let context = Context::plain(tree);
        let (mut bits, mut missed) = (0, 0);
        for places in some.chunks(SOME) {
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

    /// Some of the wrong pixels, by the object that is seen and the lights that reach it;
    /// the largest group first.
    fn groups(&self, tree: &Tree, wrong: &[Pixel]) -> Vec<Vec<Pixel>> {
        let few = spread(wrong, 2000, 0);
        let (context, diffuse) = (Context::plain(tree), tree.find("I_d"));
        let diffuse = diffuse.filter(|line| tree.lines[*line].is_needed);
        let mut groups: Vec<(usize, Vec<Pixel>)> = vec![];
        for places in few.chunks(SOME) {
            let values = Values::at(tree, places, 1);
            let values = values.changed(&context);
            for (k, place) in places.iter().enumerate() {
                let object = values.line(tree.nearest, 0).scalar(k);
                let mut key = (1.0 + object) as usize;
                for light in 0..2 {
                    let is_lit =
                        |line| values.line(line, light).vector(k) != DVec3::ZERO;
                    key = 2 * key + usize::from(diffuse.is_some_and(is_lit));
                }
                match groups.iter_mut().find(|(other, _)| *other == key) {
                    Some((_, group)) => group.push(*place),
                    None => groups.push((key, vec![*place])),
                }
            }
        }
        sort(&mut groups, |(_, group)| [usize::MAX - group.len(), 0]);
        groups.into_iter().map(|(_, group)| group).collect()
    }
}

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

/// What becomes of the wrong pixels with an edit.
struct Rated {
    /// Which it is.
    edit: usize,
    /// How many it mends.
    mended: usize,
    /// How far they all still are.
    far: usize,
    after: Vec<[u8; 3]>,
}

impl Rated {
    /// None where it spoils a third of those that are right.
    fn of(
        evidence: &Evidence,
        part: &Part,
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
        if rights + 16 < 3 * spoilt {
            return None;
        }
        let (mut mended, mut far, mut after) = (0, 0, vec![]);
        for (places, values) in &part.wrong {
            for (place, p) in places.iter().zip(values.changed(&context).pixels()) {
                mended += usize::from(evidence.is_right(part, *place, p));
                let yours = evidence.pixel(*place);
                for k in 0..3 {
                    let off = usize::from(yours[k].abs_diff(p[k]));
                    far += counted(yours[k], off);
                }
                after.push(p);
            }
        }
        Some(Self { edit, mended, far, after })
    }
}

/// The edits that mend most, and those that bring nearest.
fn best<'e>(evidence: &Evidence, edits: Vec<&'e Edit>) -> Vec<&'e Edit> {
    let [_, few, more, most] = &evidence.parts;
    let rated = |part: &Part, all: Vec<usize>| {
        each(all, |k| Rated::of(evidence, part, k, &edits[k].changes))
    };
    let same = |part: &Part| Rated::of(evidence, part, 0, &[]);
    let (Some(few_same), Some(most_same)) = (same(few), same(most)) else {
        return vec![];
    };
    // Most change none of a few pixels, or spoil them.
    let mut all = rated(few, (0..edits.len()).collect());
    all.retain(|one| 0 < one.mended || one.far < few_same.far);
    let all = all.iter().map(|one| one.edit).collect();
    // Some seem good to few pixels; many tell.
    let some = first(&mut rated(more, all), 80, 16);
    let mut all = rated(most, some);
    all.retain(|one| {
        most_same.after.len() / 16 < one.mended || 3 * one.far < 2 * most_same.far
    });
    first(&mut all, 14, 4).into_iter().map(|k| edits[k]).collect()
}

/// The first of those that mend most and of those that bring nearest, in their order; of
/// what makes the same pixels, only some.
fn first(all: &mut [Rated], most: usize, alike: usize) -> Vec<usize> {
    let mut first = vec![];
    for by_far in [false, true] {
        sort(all, |one| {
            let mended = usize::MAX - one.mended;
            if by_far { [one.far, mended] } else { [mended, one.far] }
        });
        let mut taken = vec![];
        for one in &*all {
            let same = taken.iter().filter(|after| **after == &one.after).count();
            if taken.len() < most && same < alike {
                taken.push(&one.after);
                first.push(one.edit);
            }
        }
    }
    sort(&mut first, |k| [*k, 0]);
    first.dedup();
    first
}
