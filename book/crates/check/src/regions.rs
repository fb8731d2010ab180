use crate::answer::join_first;
use crate::comparison::Comparison;
use crate::drawing::{Drawing, ObjectHit, bytes};
use std::cmp::Reverse;
use step01_rays::direction_colour;

const MOST_REGIONS: usize = 3;

/// Sentences about wrong pixels that show the sky or another object in place of the one that ours
/// shows, and about the objects all of whose pixels do.
pub(crate) fn hidden_objects(comparison: &Comparison, drawing: &Drawing) -> Vec<String> {
    let mut missing: Vec<_> = vec![None; drawing.own.scene.objects.len()];
    let mut count = 0;
    for pixel in &comparison.pixels {
        let Some(ObjectHit { object: k, .. }) = pixel.hit else { continue };
        let others = drawing.object_hits(&pixel.ray).filter(|hit| hit.object != k);
        let colours = others.map(|hit| drawing.colour_at_hit(&pixel.ray, hit));
        let mut colours = colours.chain([direction_colour(&pixel.ray)]);
        let shows_other = pixel.is_wrong() && colours.any(|colour| bytes(colour) == pixel.yours);
        count += usize::from(shows_other);
        missing[k] = Some(missing[k].unwrap_or(true) && shows_other);
    }
    let names = drawing.object_names().into_iter().zip(&missing);
    let names = names.filter(|(_, missing)| **missing == Some(true)).map(|(name, _)| name);
    let names = names.collect::<Vec<_>>().join(", ");
    let mut sentences = vec![];
    if !names.is_empty() {
        sentences.push(format!("Where ours shows {names}, what lies behind shows instead."));
    }
    let all = comparison.wrong_pixels().len();
    // Few may be so by chance.
    if all <= 10 * count {
        sentences.push(format!(
            "{count} of {all} wrong pixels have the colour of what lies behind, an object or the \
             sky."
        ));
    }
    sentences
}

/// A line about the sky and the objects of ours: which are right in every pixel, and how many
/// pixels of the others are wrong.
pub(crate) fn describe_regions(comparison: &Comparison, drawing: &Drawing) -> String {
    let mut counts = vec![(0, 0); drawing.own.scene.objects.len() + 1];
    for pixel in &comparison.pixels {
        let (wrong, all) = &mut counts[pixel.hit.map_or(0, |hit| hit.object + 1)];
        *wrong += usize::from(pixel.is_wrong());
        *all += 1;
    }
    let names = [vec!["the sky".to_owned()], drawing.object_names()].concat();
    let regions = || (0..counts.len()).filter(|k| counts[*k].1 != 0);
    let right: Vec<_> = regions().filter(|k| counts[*k].0 == 0).map(|k| &*names[k]).collect();
    let mut wrong: Vec<_> = regions().filter(|k| counts[*k].0 != 0).collect();
    wrong.sort_by_key(|k| Reverse(counts[*k].0));
    let told = wrong.iter().map(|k| {
        let (count, all) = counts[*k];
        format!("{count} of {all} pixels of {}", names[*k])
    });
    let told = join_first(told.collect(), MOST_REGIONS, "; ");
    let right = match right.len() {
        0 => String::new(),
        _ if wrong.len() <= MOST_REGIONS => " Everything else is right in every pixel.".to_owned(),
        _ => format!(" Right in every pixel: {}.", right.join(", ")),
    };
    format!("Wrong: {told}.{right}\n")
}
