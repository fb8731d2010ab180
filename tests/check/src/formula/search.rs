use super::{Change, Context, Edit, SOME, Tree, Value, Values};
use crate::{at_once, each};
use image::RgbImage;

/// Column and row of a pixel.
pub(crate) type Pixel = (u32, u32);

/// Some pixels, and the values of all lines there.
pub(crate) type Known = (Vec<Pixel>, Values);

/// Some pixels of a picture, and what a tree makes of them.
pub(crate) struct Evidence<'a> {
    pub tree: &'a Tree,
    yours: &'a RgbImage,
    /// Few pixels, then more.
    pub parts: [Part; 3],
}

/// Some pixels, those that differ apart from the others.
pub(crate) struct Part {
    pub wrong: Vec<Known>,
    pub right: Vec<Known>,
}

impl Part {
    pub fn all(&self) -> impl Iterator<Item = &Known> {
        self.wrong.iter().chain(&self.right)
    }
}

impl<'a> Evidence<'a> {
    /// Of the pixels `wrong`, which differ, and of others that may do so, too.
    pub fn new(
        tree: &'a Tree,
        yours: &'a RgbImage,
        samples: u32,
        wrong: &[Pixel],
        right: &[Pixel],
    ) -> Self {
        let context = Context::plain(tree);
        let many = 1 + samples as usize * samples as usize / 4;
        let known = |all: &[Pixel], count: usize, size: usize| {
            let some = spread(all, count / many + 2, count);
            let known = |places: &[Pixel]| {
                let values = Values::at(tree, places, samples);
                (places.to_vec(), values.filled(&context))
            };
            some.chunks(size).map(known).collect()
        };
        // One by one first: a value of one ray needs no list.
        let parts = [(4, 2, 1), (24, 16, SOME), (360, 240, SOME)];
        let parts = parts.map(|(some, others, size)| Part {
            wrong: known(wrong, some, size),
            right: known(right, others, size),
        });
        Self { tree, yours, parts }
    }

    /// Whether the tree with these changes gives each of the pixels.
    pub fn fits(&self, changes: &[Change], free: Value) -> bool {
        let context = Context::new(self.tree, changes, free);
        self.parts
            .iter()
            .flat_map(Part::all)
            .all(|known| self.is_right(known, &context))
    }

    /// Whether some pixels are those of the picture.
    pub fn is_right(&self, (places, values): &Known, context: &Context) -> bool {
        let yours = places.iter().map(|place| self.pixel(*place));
        values.changed(context).pixels().into_iter().eq(yours)
    }

    pub fn pixel(&self, (i, j): Pixel) -> [u8; 3] {
        self.yours.get_pixel(i, j).0
    }

    /// Those of some edits that give each of the pixels.
    pub fn survivors(&self, edits: Vec<Edit>) -> Vec<Edit> {
        each(edits, |edit| self.fits(&edit.changes, 0.0.into()).then_some(edit))
    }
}

/// About so many of some pixels, evenly, beginning anywhere.
fn spread(all: &[Pixel], count: usize, start: usize) -> Vec<Pixel> {
    let step = all.len() / count.max(1) + 1;
    all.iter().skip(start % step).step_by(step).copied().collect()
}

/// The pixels among `places` that differ from what a tree makes, as far as there are at
/// most so many.
pub(crate) fn misses(
    tree: &Tree,
    yours: &RgbImage,
    samples: u32,
    places: &[Pixel],
    most: usize,
) -> Vec<Pixel> {
    let context = Context::plain(tree);
    let missed = |places: &[Pixel]| {
        let values = Values::at(tree, places, samples);
        let pixels = values.changed(&context).pixels();
        let both = places.iter().copied().zip(pixels);
        let wrong =
            both.filter(|((i, j), pixel)| yours.get_pixel(*i, *j).0 != *pixel);
        Some(wrong.map(|(place, _)| place).collect::<Vec<_>>())
    };
    // All processors look at some each, as long as too few are found.
    let some = SOME / samples.min(8) as usize;
    let mut wrong = vec![];
    for places in places.chunks(at_once() * some) {
        for these in each(places.chunks(some).collect(), missed) {
            wrong.extend(these);
        }
        if most < wrong.len() {
            break;
        }
    }
    wrong.truncate(most.saturating_add(1));
    wrong
}
