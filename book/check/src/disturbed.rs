use crate::Step;
use crate::camera_from_sky::range_with_margin;
use crate::evidence::{Evidence, Pixel};
use crate::explanation::Explanation;
use crate::step_scene::{intensity_function, scene_of_step};
use crate::wrong_regions::regions_with_names;
use std::collections::{HashMap, HashSet};

const CAMERA: &str = "step01_rays/camera.rs";
const RENDER: &str = "step01_rays/render.rs";

/// A picture in which a few pixels are off by one, and those at edges perhaps by more: the
/// formulas are right, and what differs is in the last digits.
pub(crate) fn rounding_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    let wrong = evidence.wrong_pixels().len();
    let step = evidence.step?;
    let is_spread = regions_with_names(step).iter().all(|(_, is_in)| {
        let (wrong, all) = evidence.count_wrong_and_all(is_in);
        wrong <= 3.max(all / 100)
    });
    let by_one = evidence
        .wrong_pixels()
        .iter()
        .filter(|pixel| pixel.largest_channel_difference() == 1)
        .count();
    // What is rounded otherwise is brighter as often as darker; a mistake is not.
    let is_brighter = |pixel: &&Pixel| {
        let sum =
            |colour: [u8; 3]| colour.iter().map(|c| u32::from(*c)).sum::<u32>();
        sum(pixel.ours) < sum(pixel.yours)
    };
    let brighter = evidence.wrong_pixels().iter().filter(is_brighter).count();
    let is_mixed = wrong < 6 || 4 * brighter.min(wrong - brighter) >= wrong / 2;
    let is_few = 200 * wrong <= evidence.pixels.len() && wrong <= 2 * by_one;
    if !is_spread || !is_mixed || !is_few {
        return None;
    }
    let sentence = format!(
        "{wrong} of {} pixels differ, by 1 or at an edge: the formulas are right, and \
         differ in the last digits. Are there f32 in place of f64, or another order of \
         sums and products?",
        evidence.pixels.len()
    );
    let intensity = intensity_function(step, &scene_of_step(step));
    Some(Explanation::within_range(sentence, &[], move |pixel| {
        let offsets =
            [(0.0, 0.0), (0.02, 0.0), (-0.02, 0.0), (0.0, 0.02), (0.0, -0.02)];
        let colours = offsets.map(|(u, v)| {
            let ray =
                evidence.camera.ray(f64::from(pixel.i) + u, f64::from(pixel.j) + v);
            evidence.encode(intensity(&ray))
        });
        range_with_margin(&colours, 1)
    }))
}

/// Rays through other places of the pixels than their middles: all shifted alike, or on a
/// grid with another start.
pub(crate) fn shifted_ray_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    evidence.step.into_iter().flat_map(move |step| {
        let halves = [-1.0, -0.5, 0.0, 0.5, 1.0];
        let shifts = halves.into_iter().flat_map(move |u| halves.map(|v| (u, v)));
        let shifts = shifts.filter(|place| *place != (0.0, 0.0));
        let shifted = shifts.map(move |(u, v)| {
            let sentence = format!(
                "Your rays do not go through the middles of the pixels, but through i {} and \
                 j {}.",
                format_sign_and_number(u),
                format_sign_and_number(v)
            );
            ray_offsets_candidate(evidence, step, sentence, &[CAMERA, RENDER], vec![(u, v)])
        });
        let corners = [2, 3, 4].into_iter().flat_map(move |side: u32| {
            let starts = [(0.0, "0"), (0.5, "1/2 of a part"), (-0.5, "−1/2")];
            starts.into_iter().map(move |(start, words)| {
                let offset = move |k: u32| match start {
                    -0.5 => f64::from(k) / f64::from(side) - 0.5,
                    start => (f64::from(k) + start) / f64::from(side),
                };
                let grid = (0..side).flat_map(|k| (0..side).map(move |l| (offset(l), offset(k))));
                let sentence = format!(
                    "Each pixel has {side}×{side} rays, whose places begin at {words} and not \
                     around the middle."
                );
                ray_offsets_candidate(evidence, step, sentence, &[RENDER], grid.collect())
            })
        });
        shifted.chain(corners)
    })
}

fn format_sign_and_number(shift: f64) -> String {
    let sign = if shift < 0.0 { '−' } else { '+' };
    format!("{sign} {}", shift.abs())
}

/// The mean of some rays, whose places are relative to the middle of a pixel.
fn ray_offsets_candidate<'a>(
    evidence: &'a Evidence,
    step: Step,
    sentence: String,
    files: &[&'static str],
    places: Vec<(f64, f64)>,
) -> Explanation<'a> {
    let intensity = intensity_function(step, &scene_of_step(step));
    let rays = places.len() as u32;
    let mut explanation = Explanation::exact(sentence, files, move |pixel| {
        let colour = |(u, v): &(f64, f64)| {
            let (i, j) = (f64::from(pixel.i) + u, f64::from(pixel.j) + v);
            intensity(&evidence.camera.ray(i, j))
        };
        let sum = places.iter().map(colour).fold(glam::DVec3::ZERO, |a, b| a + b);
        evidence.encode(sum / f64::from(rays))
    });
    explanation.rays = rays;
    explanation
}

/// Each pixel as some places within a pixel of its middle would have it.
pub(crate) fn random_ray_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    let step = evidence.step?;
    // In the sky, a slope, another place in the pixel changes little, but something.
    let (wrong_sky, sky) =
        evidence.count_wrong_and_all(|pixel| pixel.region.object.is_none());
    if sky < 4 * wrong_sky || 200 * wrong_sky < sky {
        return None;
    }
    let intensity = intensity_function(step, &scene_of_step(step));
    let sentence = "Each pixel shows what rays within one pixel of its middle see: your rays go \
                    through other places of the pixels, as random or shifted ones do, or the \
                    picture was blurred.";
    let mut explanation =
        Explanation::within_range(sentence, &[RENDER], move |pixel| {
            let offsets = [-1.0, -0.5, 0.0, 0.5, 1.0];
            let places = offsets.into_iter().flat_map(|u| offsets.map(|v| (u, v)));
            let colours = places.map(|(u, v)| {
                let (i, j) = (f64::from(pixel.i) + u, f64::from(pixel.j) + v);
                evidence.encode(intensity(&evidence.camera.ray(i, j)))
            });
            range_with_margin(&colours.collect::<Vec<_>>(), 2)
        });
    explanation.rays = 25;
    // An edge may lie between two of these places.
    explanation.exceptions = 1000;
    explanation.only_wrong = true;
    Some(explanation)
}

/// The side of the squares in which means are compared: that of a JPEG's.
const SQUARE: u32 = 16;

/// How far a mean over a square may be off.
const MEAN: u64 = 14;

/// Ours, a little off everywhere: in each small square the mean is about ours, and what
/// differs there is brighter as often as darker.
pub(crate) fn lossy_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    let (wrong, all) = (evidence.wrong_pixels().len(), evidence.pixels.len());
    let (wrong_sky, sky) =
        evidence.count_wrong_and_all(|pixel| pixel.region.object.is_none());
    if wrong < all / 100 || wrong_sky < sky / 100 || !evidence.has_all_rows() {
        return None;
    }
    if evidence.step.is_none() && !are_flat_parts_changed(evidence) {
        return None;
    }
    let mut squares: HashMap<(u32, u32), ([i64; 3], u64, u64)> = HashMap::new();
    for pixel in &evidence.pixels {
        let square = (pixel.i / SQUARE, pixel.j / SQUARE);
        let (sums, distance, count) = squares.entry(square).or_default();
        for (k, sum) in sums.iter_mut().enumerate() {
            let difference = i64::from(pixel.yours[k]) - i64::from(pixel.ours[k]);
            *sum += difference;
            *distance += difference.unsigned_abs();
        }
        *count += 1;
    }
    let (colours_in_yours, colours_in_ours) = (
        count_colours(evidence, |pixel| pixel.yours),
        count_colours(evidence, |pixel| pixel.ours),
    );
    let has_few = colours_in_yours <= 256 && 4 * colours_in_yours < colours_in_ours;
    let mean = if has_few { 2 * MEAN } else { MEAN };
    // The squares at the end of a row may be thin.
    let is_like_ours = squares.values().all(|(sums, _, count)| {
        sums.iter().all(|sum| sum.unsigned_abs() <= mean * (*count).max(128))
    });
    let bias: u64 = squares
        .values()
        .flat_map(|(sums, ..)| sums)
        .map(|sum| sum.unsigned_abs())
        .sum();
    let distance: u64 = squares.values().map(|(_, distance, _)| distance).sum();
    if !is_like_ours || 5 * bias > 3 * distance && !has_few {
        return None;
    }
    let cause = match has_few {
        true => format!("it has only {colours_in_yours} colours, as a GIF has, and ours has {colours_in_ours}"),
        false => "it was packed with loss (JPEG, WebP), scaled and scaled back or blurred, or \
                  something random was added"
            .to_owned(),
    };
    let sentence = format!(
        "Your picture is ours, a little off in {wrong} of {all} pixels, and in each small \
         square about as bright: {cause}. Give the file that the program wrote."
    );
    Some(Explanation::within_range(sentence, &[], |_| [[0; 3], [255; 3]]))
}

/// Whether much is changed where ours is flat: a ray through another place changes only what
/// is at an edge.
fn are_flat_parts_changed(evidence: &Evidence) -> bool {
    let ours = &evidence.ours;
    let is_flat = |pixel: &Pixel| {
        [(0, 1), (1, 0), (1, 2), (2, 1)].into_iter().all(|(u, v)| {
            let place =
                ((pixel.i + u).checked_sub(1), (pixel.j + v).checked_sub(1));
            let (Some(i), Some(j)) = place else { return false };
            let neighbour = ours.get_pixel_checked(i, j);
            neighbour.is_some_and(|neighbour| neighbour.0 == pixel.ours)
        })
    };
    let (wrong, all) = evidence.count_wrong_and_all(is_flat);
    500 < all && all < 4 * wrong
}

fn count_colours(evidence: &Evidence, colour: fn(&Pixel) -> [u8; 3]) -> usize {
    let colours: HashSet<_> = evidence.pixels.iter().map(colour).collect();
    colours.len()
}

/// Explanation: what has one colour in ours has one in the picture, in the sky and
/// in the objects.
pub(crate) fn recoloured_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    evidence.step.filter(|step| Step::Rays < *step)?;
    let is_sky = |pixel: &Pixel| pixel.region.object.is_none();
    let (wrong_sky, sky) = evidence.count_wrong_and_all(is_sky);
    let (wrong_objects, objects) =
        evidence.count_wrong_and_all(|pixel| !is_sky(pixel));
    if 2 * wrong_sky < sky || 2 * wrong_objects < objects || objects == 0 {
        return None;
    }
    let mut colours: HashMap<[u8; 3], [[u8; 3]; 2]> = HashMap::new();
    for Pixel { yours, ours, .. } in &evidence.pixels {
        let [low, high] = colours.entry(*ours).or_insert([*yours; 2]);
        for k in 0..3 {
            (low[k], high[k]) = (low[k].min(yours[k]), high[k].max(yours[k]));
            if 2 < high[k] - low[k] {
                return None;
            }
        }
    }
    if evidence.pixels.len() < 3 * colours.len() {
        return None;
    }
    let sentence = "What has one colour in ours has one in your picture, but another: all of \
                    it was recoloured, as by a colour profile, or rgb8 mixes the channels.";
    Some(Explanation::within_range(
        sentence,
        &["step01_rays/rgb8.rs"],
        move |pixel| colours[&pixel.ours],
    ))
}
