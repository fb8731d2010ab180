use crate::byte_facts::{black_block, byte_curve, byte_facts};
use crate::comparison::{Comparison, Pixel};
use crate::regions::{missing_objects, wrong_sky};
use crate::scene_facts::{hit_facts, light_facts, sample_facts};

/// The most facts that are told.
const MOST_FACTS: usize = 3;

/// How many pixels are asked of a fact before all are.
pub(crate) const FIRST_PIXELS: usize = 500;

/// Something that is true of wrong pixels.
pub(crate) struct Fact<'a> {
    /// Of the facts of one group, only the first is told.
    group: &'static str,
    /// It is told where it holds for at least one wrong pixel in so many.
    one_in: usize,
    /// Words that follow after `Each wrong pixel`, beginning with `is` or `has`.
    words: String,
    holds: Box<dyn Fn(&Pixel) -> bool + 'a>,
}

/// A fact, told where it holds for at least one wrong pixel in `one_in`.
pub(crate) fn fact<'a>(
    group: &'static str,
    one_in: usize,
    words: impl Into<String>,
    holds: impl Fn(&Pixel) -> bool + 'a,
) -> Fact<'a> {
    Fact { group, one_in, words: words.into(), holds: Box::new(holds) }
}

/// Sentences that are true of the wrong pixels, the strongest first.
pub(crate) fn tell_facts(comparison: &Comparison) -> Vec<String> {
    if let Some(block) = black_block(comparison) {
        return vec![block];
    }
    let wrong = comparison.wrong_pixels();
    let mut sentences: Vec<_> = byte_curve(comparison).into_iter().collect();
    let mut facts = vec![];
    if let Some(drawing) = comparison.drawing {
        sentences.extend(missing_objects(comparison, drawing));
        sentences.extend(wrong_sky(comparison, drawing));
        facts.extend(sample_facts(drawing));
        facts.extend(light_facts(drawing));
        facts.extend(hit_facts(drawing));
    }
    facts.extend(byte_facts(comparison));
    let mut groups = vec![];
    for Fact { group, one_in, words, holds } in facts {
        let count_in = |pixels: &[Pixel]| pixels.iter().filter(|pixel| holds(pixel)).count();
        // Where it holds for too few of the first, all need not be asked.
        let first = &wrong[..wrong.len().min(FIRST_PIXELS)];
        if groups.contains(&group) || 2 * one_in * count_in(first) < first.len() {
            continue;
        }
        let (count, all) = (count_in(wrong), wrong.len());
        if all <= one_in * count {
            sentences.push(fact_sentence(&words, count, all));
            groups.push(group);
        }
    }
    sentences.truncate(MOST_FACTS);
    sentences
}

/// `Each wrong pixel is black.`, or `7 of 9 wrong pixels are black.`
fn fact_sentence(words: &str, count: usize, all: usize) -> String {
    let plural = |(is, are): (&str, &str)| Some(format!("{are}{}", words.strip_prefix(is)?));
    match [("is ", "are "), ("has ", "have ")].into_iter().find_map(plural) {
        Some(plural) if count < all => {
            format!("{count} of {all} wrong pixels {}.", plural.replace(" its ", " their "))
        }
        _ => format!("Each wrong pixel {words}."),
    }
}
