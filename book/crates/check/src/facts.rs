//! Finds facts: sentences that are true of the wrong pixels, whatever the cause.

use crate::byte_facts::{
    byte_depends_on_our_byte_sentence, byte_depends_on_our_intensity_sentence,
    copied_our_channel_or_neighbour_sentences, one_colour_sentence,
};
use crate::comparison::{Comparison, Pixel};
use crate::regions::{colours_from_behind_sentence, count_pixels_per_region, region_sentence};
use crate::step_scene::StepScene;
use crate::undrawn::undrawn_sentence;
use course::Step;
use std::collections::BTreeSet;
use step01_rays::rgb8;

const MAX_FACTS: usize = 3;

/// The minimum number of wrong pixels for a sentence about every wrong pixel. With fewer pixels,
/// too many sentences are true by chance.
const MIN_PIXELS: usize = 16;

/// The minimum number of different colours for a sentence about every wrong pixel. The colours are
/// those of our picture at the positions of the wrong pixels.
const MIN_COLOURS: usize = 4;

/// Returns sentences that are true of the wrong pixels, strongest first. If we have a scene, the
/// last sentence says where the wrong pixels are.
pub(crate) fn find_facts(comparison: &Comparison) -> Vec<String> {
    let scene = comparison.target.scene.as_ref();
    let regions = scene.map(|scene| count_pixels_per_region(comparison, scene));
    let has_enough_evidence = are_enough_evidence(&comparison.wrong);
    let scene_if_enough_evidence = scene.filter(|_| has_enough_evidence);
    // White pixels may be undrawn, but too much light also makes pixels white. So if your bytes are
    // a function of our intensities or bytes, we don't look for undrawn pixels.
    let byte_function_sentence = scene_if_enough_evidence.and_then(|scene| {
        byte_depends_on_our_intensity_sentence(comparison, scene)
            .or_else(|| byte_depends_on_our_byte_sentence(comparison, scene))
    });
    let undrawn_pixels_sentence =
        if byte_function_sentence.is_none() { undrawn_sentence(comparison) } else { None };
    let mut facts: Vec<_> = undrawn_pixels_sentence.into_iter().collect();
    if facts.is_empty() {
        facts.extend(byte_function_sentence);
        facts.extend(regions.as_deref().and_then(colours_from_behind_sentence));
        if let Some(scene) = scene_if_enough_evidence {
            if all_exceed_byte_range(&comparison.wrong, scene) {
                facts.push("Each wrong pixel has an intensity above 1 in ours.".to_owned());
            }
            facts.extend(missing_terms_sentence(&comparison.wrong, scene));
        }
        if has_enough_evidence {
            facts.extend(one_colour_sentence(&comparison.wrong));
            facts.extend(copied_our_channel_or_neighbour_sentences(comparison));
        }
        facts.truncate(MAX_FACTS);
    }
    facts.extend(regions.map(region_sentence));
    facts
}

/// Whether there are enough wrong pixels, and our picture has enough different colours at these
/// pixels. If so, a sentence that is true of every wrong pixel is unlikely to be true by chance.
fn are_enough_evidence(wrong: &[Pixel]) -> bool {
    let colours: BTreeSet<[u8; 3]> = wrong.iter().map(|pixel| pixel.ours).collect();
    wrong.len() >= MIN_PIXELS && colours.len() >= MIN_COLOURS
}

/// Whether each of `pixels` has, in our picture, an intensity that is too large for a byte.
fn all_exceed_byte_range(pixels: &[Pixel], scene: &StepScene) -> bool {
    pixels.iter().all(|pixel| scene.colour(&pixel.ray).max_element() > 1.0)
}

/// Names the terms that are missing from every wrong pixel. At each of these pixels, our sum
/// without the missing terms gives your colour. If several sets of terms fit, names a set with the
/// fewest terms. Returns None if no set fits.
fn missing_terms_sentence(wrong: &[Pixel], scene: &StepScene) -> Option<String> {
    let light_terms = |term| scene.light_names.map(|light| format!("the {term} term of {light}"));
    let ambient = ["the ambient term".to_owned()];
    let names = [&ambient[..], &light_terms("diffuse"), &light_terms("specular")].concat();
    let count = match scene.step {
        Step::Diffuse => 3,
        Step::Phong => 5,
        _ => return None,
    };
    let is_left_out = |choice: usize, k: usize| choice >> k & 1 == 1;
    // No choice leaves out all terms. The sentence about such a choice would only mean that every
    // wrong pixel is black.
    let choices = 1..(1_usize << count) - 1;
    let mut smallest_first = (1..count as u32)
        .flat_map(|terms| choices.clone().filter(move |choice| choice.count_ones() == terms));
    let lights = &scene.own_scene.scene.lights;
    let choice = smallest_first.find(|choice| {
        wrong.iter().all(|Pixel { ray, hit, yours, .. }| {
            let Some(hit) = *hit else { return false };
            let ambient = scene.ambient_at_hit(hit);
            let [warm, cool] = [0, 1].map(|k| scene.light_terms_at_hit(ray, hit, &lights[k]));
            let terms = [ambient, warm.diffuse, cool.diffuse, warm.specular, cool.specular];
            let kept_indices = (0..count).filter(|k| !is_left_out(*choice, *k));
            rgb8(kept_indices.map(|k| terms[k]).sum()).0 == *yours
        })
    })?;
    let missing_terms: Vec<_> =
        (0..count).filter(|k| is_left_out(choice, *k)).map(|k| &*names[k]).collect();
    Some(format!("Each wrong pixel is what ours would be without {}.", missing_terms.join(" and ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixel(ours: [u8; 3]) -> Pixel {
        let ray = course::camera().ray(0.0, 0.0);
        Pixel { position: (0, 0), ray, hit: None, yours: [0; 3], ours }
    }

    #[test]
    fn pixels_are_enough_evidence_if_they_are_many_and_varied() {
        let pixels = |count: u8, colours: u8| {
            let pixels = (0..count).map(|k| pixel([k % colours, 0, 0]));
            pixels.collect::<Vec<_>>()
        };
        assert!(are_enough_evidence(&pixels(16, 4)));
        assert!(!are_enough_evidence(&pixels(15, 4)));
        assert!(!are_enough_evidence(&pixels(16, 3)));
    }
}
