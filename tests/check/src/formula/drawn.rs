use super::{Context, Tree, Value, Values, edits};
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
    let context = Context { tree: &tree, changes: &[], free: Value::from(0.0) };
    let row = |j: u32| {
        let places: Vec<_> = (0..width).map(|i| (i, j)).collect();
        Values::at(&context, &places, samples).pixels(&context)
    };
    let rows: Vec<_> = (0..height).map(row).collect();
    Some(RgbImage::from_fn(width, height, |i, j| Rgb(rows[j as usize][i as usize])))
}
