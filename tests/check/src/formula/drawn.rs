use super::{Context, Tree, Values, batch, edits};
use crate::Step;
use image::{Rgb, RgbImage};

/// The picture that the formulas draw, with the k-th of their edits if that is given:
/// the edits are those that `check` tries, the likeliest first.
///
/// None where there are not so many.
pub fn by_formulas(
    step: Step,
    (width, height): (u32, u32),
    samples: u32,
    edit: Option<usize>,
) -> Option<RgbImage> {
    let mut tree = Tree::new(step, (width, height), crate::fov::FOV, samples);
    if let Some(edit) = edit {
        tree = tree.with(&edits(&tree).get(edit)?.changes);
    }
    let context = Context::plain(&tree);
    let mut picture = RgbImage::new(width, height);
    let all = (0..height).flat_map(|j| (0..width).map(move |i| (i, j)));
    for places in all.collect::<Vec<_>>().chunks(batch(samples)) {
        let values = Values::at(&tree, places, samples);
        for ((i, j), pixel) in places.iter().zip(values.changed(&context).pixels())
        {
            picture.put_pixel(*i, *j, Rgb(pixel));
        }
    }
    Some(picture)
}
