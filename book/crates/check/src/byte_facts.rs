//! Finds facts about the bytes of the wrong pixels.

use crate::answer::join_first;
use crate::comparison::{Comparison, Pixel};
use crate::step_scene::StepScene;
use course::Step;
use std::collections::BTreeSet;
use std::iter::zip;

/// A sentence blames the conversion to bytes only if at least this many different byte values are
/// wrong. If fewer values are wrong, the cause could be a wrong colour.
const MIN_CHANGED_VALUES: usize = 16;

/// The maximum number of bytes listed in one sentence.
const MAX_BYTES: usize = 3;

/// The number of pixels that we test first. If your bytes in these pixels aren't a monotonic
/// function of our intensities, we don't test the other pixels.
const PIXELS_TESTED_FIRST: usize = 500;

/// Returns a sentence for each of these facts that is true of all wrong pixels:
///
/// - The pixel has one of our channels in all three bytes.
/// - The pixel has the colour of a neighbouring pixel in our picture.
pub(crate) fn copied_our_channel_or_neighbour_sentences(comparison: &Comparison) -> Vec<String> {
    let mut sentences = vec![];
    let mut add_if = |words: &str, holds: &dyn Fn(&Pixel) -> bool| {
        if comparison.wrong.iter().all(holds) {
            sentences.push(format!("Each wrong pixel {words}."));
        }
    };
    for (k, name) in ["red", "green", "blue"].into_iter().enumerate() {
        let words = format!("has our {name} in all three bytes");
        add_if(&words, &|pixel| pixel.yours == [pixel.ours[k]; 3]);
    }
    add_if("has the colour of a neighbour in ours", &|pixel| {
        let ours = &comparison.target.picture;
        neighbourhood_3x3(pixel.position).any(|(i, j)| {
            ours.get_pixel_checked(i, j).is_some_and(|colour| colour.0 == pixel.yours)
        })
    });
    sentences
}

/// Returns the positions of a pixel and of the pixels around it. Some of these positions may lie
/// beyond the right or bottom edge of the picture.
fn neighbourhood_3x3((i, j): (u32, u32)) -> impl Iterator<Item = (u32, u32)> {
    let rows = j.saturating_sub(1)..=j + 1;
    rows.flat_map(move |row| (i.saturating_sub(1)..=i + 1).map(move |column| (column, row)))
}

/// Describes the wrong pixels if they all have the same colour.
pub(crate) fn one_colour_sentence(wrong: &[Pixel]) -> Option<String> {
    let [r, g, b] = wrong.first()?.yours;
    let is_one = wrong.iter().all(|pixel| pixel.yours == [r, g, b]);
    is_one.then(|| format!("Each wrong pixel is ({r}, {g}, {b})."))
}

/// Describes your bytes as a function of ours. Returns None in two cases:
///
/// - There is no such function, since equal bytes of ours became different bytes of yours.
/// - Few byte values have changed, and only the sky or only the objects differ. Then the cause may
///   be a wrong colour instead of a wrong conversion to bytes.
pub(crate) fn byte_depends_on_our_byte_sentence(
    comparison: &Comparison,
    scene: &StepScene,
) -> Option<String> {
    let mut yours_of_ours = [None; 256];
    for Pixel { yours, ours, .. } in comparison.pixels() {
        for (yours, ours) in zip(yours, ours) {
            if *yours_of_ours[usize::from(*ours)].get_or_insert(*yours) != *yours {
                return None;
            }
        }
    }
    let changed: Vec<_> = zip(0..=u8::MAX, yours_of_ours)
        .filter_map(|(ours, yours)| Some((ours, yours?)))
        .filter(|(ours, yours)| ours != yours)
        .collect();
    if changed.len() < MIN_CHANGED_VALUES && only_sky_or_only_objects_differ(comparison, scene) {
        return None;
    }
    let file = advice_on_source_files_to_compare(changed.len(), scene);
    let clauses = changed.iter().map(|(ours, yours)| format!("{ours} becomes {yours}"));
    let examples = join_first(clauses.collect(), MAX_BYTES, ", ");
    Some(format!("Each byte depends only on ours: {examples}.{file}"))
}

/// Whether only the sky or only the objects differ. If so, the cause may be a wrong colour instead
/// of a wrong conversion to bytes. Returns false in step 1, which has no objects.
fn only_sky_or_only_objects_differ(comparison: &Comparison, scene: &StepScene) -> bool {
    let wrong_sky = comparison.wrong.iter().filter(|pixel| pixel.hit.is_none()).count();
    scene.step > Step::Rays && [0, comparison.wrong.len()].contains(&wrong_sky)
}

/// Returns a sentence that names the files to compare. The sentence is empty if fewer than
/// `MIN_CHANGED_VALUES` byte values have changed. The sentence is also empty in steps 1 and 2,
/// where a wrong `direction_colour` looks the same as a wrong conversion to bytes.
fn advice_on_source_files_to_compare(
    changed_value_count: usize,
    scene: &StepScene,
) -> &'static str {
    let is_known = changed_value_count >= MIN_CHANGED_VALUES && scene.step > Step::Sphere;
    if is_known { " Compare rgb8.rs and the mean in render.rs of step 1." } else { "" }
}

/// Describes your bytes as a monotonic function of our intensities. Returns None if there is no
/// such function, or if only the sky or only the objects differ.
pub(crate) fn byte_depends_on_our_intensity_sentence(
    comparison: &Comparison,
    scene: &StepScene,
) -> Option<String> {
    if only_sky_or_only_objects_differ(comparison, scene) {
        return None;
    }
    // For most pictures, a few pixels are enough to rule out such a function.
    sorted_points_if_monotonic(comparison.pixels().take(PIXELS_TESTED_FIRST), scene)?;
    let mut changed_points = sorted_points_if_monotonic(comparison.pixels(), scene)?;
    changed_points.retain(|(_, yours, ours)| yours != ours);
    let examples = [1, 3, 5].map(|sixths| changed_points[sixths * changed_points.len() / 6]);
    let mut clauses =
        examples.map(|(i, yours, ours)| format!("{i:.3} becomes {yours} (ours: {ours})")).to_vec();
    clauses.dedup();
    let values: BTreeSet<u32> =
        changed_points.iter().map(|(_, yours, _)| u32::from(*yours)).collect();
    let file = advice_on_source_files_to_compare(values.len(), scene);
    Some(format!("Each byte depends only on our intensity: {}.{file}", clauses.join(", ")))
}

/// Returns all intensities of these pixels in ascending order, each with your byte and our byte.
/// Returns None unless your bytes are a monotonic function of the intensities.
fn sorted_points_if_monotonic<'a>(
    pixels: impl Iterator<Item = &'a Pixel>,
    scene: &StepScene,
) -> Option<Vec<(f64, u8, u8)>> {
    let mut points: Vec<_> = pixels
        .flat_map(|pixel| {
            let intensity = scene.colour(&pixel.ray).to_array();
            (0..3).map(move |k| (intensity[k], pixel.yours[k], pixel.ours[k]))
        })
        .collect();
    points.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let is_monotonic = |is_ordered: fn(u8, u8) -> bool| {
        points.is_sorted_by(|(i, a, _), (j, b, _)| if i == j { a == b } else { is_ordered(*a, *b) })
    };
    (is_monotonic(|a, b| a <= b) || is_monotonic(|a, b| a >= b)).then_some(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbourhood_is_cropped_at_the_left_and_at_the_top() {
        let expected = [(4, 6), (5, 6), (6, 6), (4, 7), (5, 7), (6, 7), (4, 8), (5, 8), (6, 8)];
        assert_eq!(neighbourhood_3x3((5, 7)).collect::<Vec<_>>(), expected);
        assert_eq!(neighbourhood_3x3((0, 0)).collect::<Vec<_>>(), [(0, 0), (1, 0), (0, 1), (1, 1)]);
    }
}
