use super::{Change, Context, Edit, Tree, Value, Values};
use image::RgbImage;

/// Column and row of a pixel.
pub(crate) type Pixel = (u32, u32);

/// Some pixels of a picture, and what a tree makes of them.
pub(crate) struct Evidence<'a> {
    pub tree: &'a Tree,
    yours: &'a RgbImage,
    /// Few pixels, then more: each with the values of all lines there.
    pub parts: Vec<(Vec<Pixel>, Values)>,
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
        let context = Context { tree, changes: &[], free: Value::from(0.0) };
        let many = 1 + samples as usize * samples as usize / 4;
        let parts = [(4, 2), (24, 16), (360, 240)].map(|(some, others)| {
            let mut places = spread(wrong, some / many + 2, some);
            places.extend(spread(right, others / many + 2, others));
            let values = Values::at(&context, &places, samples);
            (places, values)
        });
        Self { tree, yours, parts: parts.into() }
    }

    /// Whether the tree with these changes gives each of the pixels.
    pub fn fits(&self, changes: &[Change], free: &Value) -> bool {
        let context = Context { tree: self.tree, changes, free: free.clone() };
        self.parts.iter().all(|(places, values)| {
            let pixels = values.changed(&context).pixels(&context);
            places.iter().zip(pixels).all(|(p, pixel)| self.pixel(*p) == pixel)
        })
    }

    pub fn pixel(&self, (i, j): Pixel) -> [u8; 3] {
        self.yours.get_pixel(i, j).0
    }

    /// Those of some edits that give each of the pixels.
    pub fn survivors(&self, edits: Vec<Edit>) -> Vec<Edit> {
        let free = Value::from(0.0);
        edits.into_iter().filter(|edit| self.fits(&edit.changes, &free)).collect()
    }
}

/// About so many of some pixels, evenly, beginning anywhere.
fn spread(all: &[Pixel], count: usize, start: usize) -> Vec<Pixel> {
    let step = all.len() / count.max(1) + 1;
    all.iter().skip(start % step).step_by(step).copied().collect()
}

/// The pixels among `places` that differ from what the tree with some changes makes.
pub(crate) fn misses(
    context: &Context,
    yours: &RgbImage,
    samples: u32,
    places: &[Pixel],
    most: usize,
) -> Vec<Pixel> {
    let mut wrong = vec![];
    for some in places.chunks(512 / samples.pow(2).min(64) as usize) {
        let values = Values::at(context, some, samples);
        let pixels = values.pixels(context);
        let its = some.iter().zip(pixels);
        wrong.extend(
            its.filter(|((i, j), p)| yours.get_pixel(*i, *j).0 != *p)
                .map(|(p, _)| *p),
        );
        if most < wrong.len() {
            break;
        }
    }
    wrong
}
