use super::words::vector;
use crate::formula::{Context, Tree, Values, is_smooth};
use crate::{Options, Step, apart};
use glam::DVec3;
use image::RgbImage;

/// The pixel that differs most, in full: yours, ours, which object, and each of its
/// terms. Of many rays a pixel, those terms are of the one through the centre: it is a
/// pixel in which that is like all of them, if there is one.
pub(crate) fn pixel(
    yours: &RgbImage,
    ours: &RgbImage,
    step: Step,
    Options { fov, samples }: Options,
) -> String {
    let pairs = yours.enumerate_pixels().zip(ours.pixels());
    let worst = pairs.max_by_key(|((i, j, a), b)| {
        let apart = apart(a, b);
        (samples == 1 || 2 < apart && is_smooth(yours, (*i, *j)), apart)
    });
    let Some(((i, j, a), b)) = worst else { return String::new() };
    let (width, height) = yours.dimensions();
    let tree = Tree::new(step, (width.max(2), height), fov, 1);
    let context = Context::plain(&tree);
    let values = Values::at(&tree, &[(i, j)], 1);
    let values = values.changed(&context);
    let vectors = |name: &str| -> Vec<DVec3> {
        let line = tree.find(name).filter(|k| tree.lines[*k].is_needed);
        let all = line.map_or(0, |line| tree.lines[line].count);
        let line = line.unwrap_or(0);
        (0..all).map(|k| values.name(line, k).vector(0)).collect()
    };
    let direction = vectors("V").first().copied().unwrap_or_default();
    let mut text = format!(
        "Column {i}, row {j}: yours is {:?}, ours {:?}. Its V is {}",
        a.0,
        b.0,
        vector(direction)
    );
    let object = vectors("nearest").first().map_or(-1.0, |v| v.x);
    if object < 0.0 {
        return text + ", and it sees the sky.";
    }
    text += &format!(", and it sees {}.", tree.object(object as usize));
    if let ([ambient], [warm, cool]) = (&vectors("I_a")[..], &vectors("I_d")[..]) {
        text += &format!(
            " I_a is {}; the warm light's I_d {}, the cool light's {}",
            vector(*ambient),
            vector(*warm),
            vector(*cool)
        );
        if let [first, second] = vectors("G")[..] {
            text +=
                &format!("; their I_s {} and {}", vector(first), vector(second));
        }
        let sum = vectors("I").first().copied().unwrap_or_default();
        text += &format!("; together {}.", vector(sum));
    }
    text
}
