//! Counts the wrong pixels in the sky and in each object.

use crate::answer::join_first;
use crate::comparison::{Comparison, Pixel};
use crate::step_scene::StepScene;
use std::cmp::Reverse;
use step01_rays::{direction_colour, rgb8};

const MAX_REGIONS: usize = 3;

/// The name of the region without objects.
const SKY: &str = "the sky";

/// All pixels that show the sky in our picture, or all pixels that show a certain object.
pub(crate) struct Region {
    name: String,
    pixel_count: usize,
    wrong_count: usize,
    /// The number of wrong pixels that show what lies behind the object on the same ray: the sky,
    /// or another object.
    from_behind_count: usize,
}

/// Counts the pixels of each region. The sky comes first, then each object. Leaves out regions that
/// aren't visible in our picture.
pub(crate) fn count_pixels_per_region(comparison: &Comparison, scene: &StepScene) -> Vec<Region> {
    let names = [vec![SKY.to_owned()], scene.object_names()].concat();
    let empty_region = |name| Region { name, pixel_count: 0, wrong_count: 0, from_behind_count: 0 };
    let mut regions: Vec<_> = names.into_iter().map(empty_region).collect();
    let is_from_behind = |Pixel { ray, yours, .. }: &Pixel| {
        let colours = scene.first_hits_on_objects(ray).map(|hit| scene.colour_at_hit(ray, hit));
        colours.chain([direction_colour(ray)]).any(|colour| rgb8(colour).0 == *yours)
    };
    let index = |pixel: &Pixel| pixel.hit.map_or(0, |hit| hit.object + 1);
    comparison.pixels().for_each(|pixel| regions[index(pixel)].pixel_count += 1);
    for pixel in &comparison.wrong {
        regions[index(pixel)].wrong_count += 1;
        regions[index(pixel)].from_behind_count += usize::from(is_from_behind(pixel));
    }
    regions.retain(|region| region.pixel_count > 0);
    regions
}

/// Says how many wrong pixels show what should be hidden behind an object, and names the objects
/// that are missing from your picture. Returns None if no object is missing and less than a tenth
/// of the wrong pixels show what should be hidden, because so few may do this by chance.
pub(crate) fn colours_from_behind_sentence(regions: &[Region]) -> Option<String> {
    let from_behind: usize = regions.iter().map(|region| region.from_behind_count).sum();
    let wrong: usize = regions.iter().map(|region| region.wrong_count).sum();
    let is_missing = |region: &&Region| region.from_behind_count == region.pixel_count;
    let missing: Vec<_> = regions.iter().filter(is_missing).map(|region| &*region.name).collect();
    if missing.is_empty() && 10 * from_behind < wrong {
        return None;
    }
    let mut sentence = format!(
        "{from_behind} of {wrong} wrong pixels have the colour of the sky or of an object that lies \
         behind"
    );
    if !missing.is_empty() {
        sentence += &format!(", including all that show {} in ours", missing.join(", "));
    }
    Some(sentence + ".")
}

/// Names the regions with the most wrong pixels, and the regions that are right in every pixel.
pub(crate) fn region_sentence(mut regions: Vec<Region>) -> String {
    regions.sort_by_key(|region| Reverse(region.wrong_count));
    let (wrong, right): (Vec<_>, Vec<_>) =
        regions.iter().partition(|region| region.wrong_count > 0);
    let counts = wrong.iter().map(|Region { name, pixel_count, wrong_count, .. }| {
        format!("{wrong_count} of {pixel_count} pixels of {name}")
    });
    let wrong_parts = join_first(counts.collect(), MAX_REGIONS, "; ");
    match right.iter().map(|region| &*region.name).collect::<Vec<_>>()[..] {
        [] => format!("It differs from ours in {wrong_parts}."),
        [_, ..] if wrong.len() == 1 && wrong[0].name == SKY => {
            let count: usize = right.iter().map(|region| region.pixel_count).sum();
            format!(
                "It differs from ours in {wrong_parts}. All {count} pixels of the objects are right."
            )
        }
        ref names => {
            let right_parts = names.join(", ");
            format!("It differs from ours in {wrong_parts}. Right in every pixel: {right_parts}.")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn region(
        name: &str,
        pixel_count: usize,
        wrong_count: usize,
        from_behind_count: usize,
    ) -> Region {
        Region { name: name.to_owned(), pixel_count, wrong_count, from_behind_count }
    }

    #[test]
    fn sentence_names_the_wrong_regions_and_the_right_ones() {
        let [sky, ball] = [region("the sky", 9, 0, 0), region("ball 1", 7, 2, 0)];
        assert_eq!(
            region_sentence(vec![sky, ball]),
            "It differs from ours in 2 of 7 pixels of ball 1. Right in every pixel: the sky."
        );
        let [sky, ball] = [region("the sky", 9, 1, 0), region("ball 1", 7, 0, 0)];
        assert_eq!(
            region_sentence(vec![sky, ball]),
            "It differs from ours in 1 of 9 pixels of the sky. All 7 pixels of the objects are \
             right."
        );
        let names_and_counts = ["a", "b", "c", "d", "e"].into_iter().zip(1..);
        let all_wrong = names_and_counts.map(|(name, count)| region(name, 5, count, 0));
        assert_eq!(
            region_sentence(all_wrong.collect()),
            "It differs from ours in 5 of 5 pixels of e; 4 of 5 pixels of d; 3 of 5 pixels of c; \
             2 more."
        );
    }

    #[test]
    fn few_pixels_with_a_colour_from_behind_give_no_sentence() {
        let sentence = |from_behind_count| {
            let wrong_region = region("a", 200, 100, from_behind_count);
            colours_from_behind_sentence(&[wrong_region, region("b", 9, 0, 0)])
        };
        assert_eq!(sentence(9), None);
        assert!(
            sentence(10).is_some_and(|sentence| sentence.starts_with("10 of 100 wrong pixels"))
        );
        let sentence =
            colours_from_behind_sentence(&[region("a", 200, 100, 1), region("b", 2, 2, 2)]);
        let end = "lies behind, including all that show b in ours.";
        assert!(sentence.is_some_and(|sentence| sentence.ends_with(end)));
    }
}
