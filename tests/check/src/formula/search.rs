use super::{Change, Context, Edit, Of, Tree, Value, Values, batch};
use crate::{apart, each};
use image::{Rgb, RgbImage};

/// Column and row of a pixel.
pub(crate) type Pixel = (u32, u32);

/// Some pixels, and the values of all lines there.
pub(crate) type Known = (Vec<Pixel>, Values);

/// By how much one ray may be another colour than all rays of a pixel, where a picture is
/// smooth.
const SLACK: u8 = 2;

/// Some pixels of a picture, and what a tree makes of them.
pub(crate) struct Evidence<'a> {
    pub tree: &'a Tree,
    yours: &'a RgbImage,
    /// Few pixels, then more; the first ones of one ray each, where that tells enough of
    /// pixels of many.
    pub parts: [Part; 4],
}

/// Some pixels, those that differ apart from the others.
pub(crate) struct Part {
    pub wrong: Vec<Known>,
    pub right: Vec<Known>,
    /// By how much one ray may be another colour than all rays of its pixel.
    pub slack: u8,
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
        let many = (samples as usize).pow(2).div_ceil(2);
        let values = |places: &[Pixel], samples: u32| {
            Values::at(tree, places, samples).filled(&context)
        };
        // Where a picture is smooth, one ray of a pixel tells about what all of them do.
        let mut is_even = |place: Pixel| 1 < samples && is_smooth(yours, place);
        let even = kept(right, &mut is_even);
        let mut tells = |place: Pixel| {
            let ours = values(&[place], 1).changed(&context).pixels();
            2 * SLACK < apart(yours.get_pixel(place.0, place.1), &Rgb(ours[0]))
        };
        let telling = kept(&spread(&kept(wrong, &mut is_even), 200, 3), &mut tells);
        let is_enough = 6 < telling.len();
        // One by one first: a value of one ray needs no list.
        let all = batch(1);
        let parts = [(4, 2, 1), (8, 4, all), (24, 16, all), (360, 240, all)];
        let parts = parts.map(|(some, others, size)| {
            // All rays of most pixels decide.
            let is_quick = is_enough && some < 100;
            let known = |all: &[Pixel], count: usize| {
                let few = if is_quick { count } else { count / many + 2 };
                let rays = if is_quick { 1 } else { samples };
                let known =
                    |places: &[Pixel]| (places.to_vec(), values(places, rays));
                spread(all, few, count).chunks(size).map(known).collect()
            };
            let (wrong, right, slack) = match is_quick {
                true => (&telling[..], &even[..], SLACK),
                false => (wrong, right, 0),
            };
            Part { wrong: known(wrong, some), right: known(right, others), slack }
        });
        Self { tree, yours, parts }
    }

    /// Whether the tree with these changes gives each of the pixels.
    pub fn fits(&self, changes: &[Change], free: Value) -> bool {
        let context = Context::new(self.tree, changes, free);
        // What makes one pixel of all its rays can't be told by one.
        let is_of_rays = |change: &Change| match change {
            Change::Line(line, _) => self.tree.lines[*line].of == Of::Pixel,
            _ => false,
        };
        let is_mean = changes.iter().any(is_of_rays);
        let fits = |part: &Part| {
            part.all().all(|known| self.fits_in(part, known, &context))
        };
        self.parts.iter().all(|part| 0 < part.slack && is_mean || fits(part))
    }

    /// Whether some pixels of a part are those of the picture.
    pub fn fits_in(
        &self,
        part: &Part,
        (places, values): &Known,
        context: &Context,
    ) -> bool {
        let mut both = places.iter().zip(values.changed(context).pixels());
        both.all(|(place, pixel)| self.is_right(part, *place, pixel))
    }

    /// Whether it is the colour of a pixel of a part.
    pub fn is_right(&self, part: &Part, (i, j): Pixel, pixel: [u8; 3]) -> bool {
        apart(self.yours.get_pixel(i, j), &Rgb(pixel)) <= part.slack
    }

    pub fn pixel(&self, (i, j): Pixel) -> [u8; 3] {
        self.yours.get_pixel(i, j).0
    }

    /// Those of some edits that give each of the pixels.
    pub fn survivors<'e>(&self, edits: Vec<&'e Edit>) -> Vec<&'e Edit> {
        each(edits, |edit| self.fits(&edit.changes, 0.0.into()).then_some(edit))
    }
}

/// Those of some pixels of which this is so.
pub(crate) fn kept(
    all: &[Pixel],
    is_so: &mut dyn FnMut(Pixel) -> bool,
) -> Vec<Pixel> {
    all.iter().filter(|place| is_so(**place)).copied().collect()
}

/// Whether the colours around a pixel change evenly, so that in its centre it has the mean
/// of them.
pub(crate) fn is_smooth(yours: &RgbImage, (i, j): Pixel) -> bool {
    let at = |u: i32, v: i32| {
        let place = (i.checked_add_signed(u)?, j.checked_add_signed(v)?);
        yours.get_pixel_checked(place.0, place.1)
    };
    let one = yours.get_pixel(i, j);
    [(1, 0), (0, 1), (1, 1), (1, -1)].into_iter().all(|(u, v)| {
        let (Some(a), Some(b)) = (at(u, v), at(-u, -v)) else { return false };
        (0..3).all(|k| {
            let [a, b, one] = [a, b, one].map(|pixel| i32::from(pixel.0[k]));
            (a - b).abs() < 24 && (a + b - 2 * one).abs() < 4
        })
    })
}

/// About so many of some pixels, evenly, beginning anywhere.
pub(crate) fn spread(all: &[Pixel], count: usize, start: usize) -> Vec<Pixel> {
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
        let mut pixels = values.changed(&context).pixels().into_iter();
        let mut is_missed = |(i, j)| Some(yours.get_pixel(i, j).0) != pixels.next();
        Some(kept(places, &mut is_missed))
    };
    // All processors look at some each, as long as too few are found.
    let some = batch(samples);
    let mut wrong = vec![];
    for places in places.chunks(8 * some) {
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
