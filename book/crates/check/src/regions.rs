use crate::comparison::{Comparison, Pixel};
use crate::drawing::Drawing;
use crate::scene_facts::{shows_another_object, shows_sky};
use course::Step;
use std::cmp::Reverse;

/// The most regions of which the wrong pixels are told.
const MOST_REGIONS: usize = 3;

/// A sentence about the objects none of whose pixels shows them: each has the colour of the
/// sky or of another object there.
pub(crate) fn missing_objects(comparison: &Comparison, drawing: &Drawing) -> Option<String> {
    let mut missing = vec![false; drawing.scene.objects.len()];
    comparison.wrong_pixels().iter().filter_map(Pixel::object).for_each(|k| missing[k] = true);
    for pixel in &comparison.pixels {
        if let Some(k) = pixel.object().filter(|k| missing[*k]) {
            let shows_what_lies_behind = shows_sky(pixel) || shows_another_object(drawing, pixel);
            missing[k] = pixel.is_wrong() && shows_what_lies_behind;
        }
    }
    let names = (0..missing.len()).filter(|k| missing[*k]).map(|k| drawing.object_name(k));
    let names = names.collect::<Vec<_>>().join(", ");
    (!names.is_empty()).then(|| format!("Missing: {names}. What lies behind shows instead."))
}

/// A sentence where the sky alone is wrong, nearly everywhere.
pub(crate) fn wrong_sky(comparison: &Comparison, drawing: &Drawing) -> Option<String> {
    let wrong = comparison.wrong_pixels();
    let sky_count = comparison.pixels.iter().filter(|one| one.is_sky()).count();
    let is_told = Step::Rays < drawing.step
        && wrong.iter().all(Pixel::is_sky)
        && 9 * sky_count < 10 * wrong.len();
    is_told.then(|| {
        "Every pixel of an object is right, so the rays are; the sky's colours aren't.".to_owned()
    })
}

/// A line about the sky and the objects of ours: which are right in every pixel, and how many
/// pixels of the others are wrong.
pub(crate) fn describe_regions(comparison: &Comparison, drawing: &Drawing) -> String {
    let mut counts = vec![(0, 0); drawing.scene.objects.len() + 1];
    for pixel in &comparison.pixels {
        let (wrong, all) = &mut counts[pixel.object().map_or(0, |k| k + 1)];
        *wrong += usize::from(pixel.is_wrong());
        *all += 1;
    }
    let (mut right, mut wrong) = (vec![], vec![]);
    for (k, count) in counts.into_iter().enumerate() {
        let name = if k == 0 { "the sky".to_owned() } else { drawing.object_name(k - 1) };
        match count {
            (_, 0) => {}
            (0, _) => right.push(name),
            (count, all) => wrong.push((count, format!("{count} of {all} pixels of {name}"))),
        }
    }
    wrong.sort_by_key(|(count, _)| Reverse(*count));
    let wrong: Vec<_> = wrong.into_iter().map(|(_, words)| words).collect();
    let worst = wrong[..wrong.len().min(MOST_REGIONS)].join("; ");
    match (wrong.len().saturating_sub(MOST_REGIONS), right.len()) {
        (0, 0) => format!("Wrong: {worst}.\n"),
        (0, _) => format!("Wrong: {worst}. Everything else is right in every pixel.\n"),
        (more, 0) => format!("Wrong: {worst}; {more} more.\n"),
        (more, _) => {
            format!("Right in every pixel: {}. Wrong: {worst}; {more} more.\n", right.join(", "))
        }
    }
}
