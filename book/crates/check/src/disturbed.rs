use crate::evidence::Evidence;
use crate::explanation::{Explanation, range_with_margin};
use crate::step_scene::{ENCODE, intensity_function, scene_of_step};
use std::collections::HashMap;

const CAMERA: &str = "step01_rays/camera.rs";
const RENDER: &str = "step01_rays/render.rs";

/// How far a place is whose colour another rounding may give, in pixels.
const ROUNDED: f64 = 0.02;

/// A picture in which a few pixels are off by one, and those at edges perhaps by more.
pub(crate) fn rounding_candidate(evidence: &Evidence) -> Option<Explanation<'_>> {
    let (wrong, all) = (evidence.wrong_pixels().len(), evidence.pixels.len());
    let step = evidence.step.filter(|_| 200 * wrong <= all)?;
    let sentence = format!(
        "{wrong} of {all} pixels differ, by 1 or at an edge, as where the formulas are right \
         and the last digits are others: are there f32 in place of f64, or another order of \
         sums and products?"
    );
    let intensity = intensity_function(step, &scene_of_step(step));
    Some(Explanation::within_range(sentence, &[], move |pixel| {
        let (i, j) = (f64::from(pixel.i), f64::from(pixel.j));
        let colours = [0.0, ROUNDED, -ROUNDED].map(|shift| {
            [(i + shift, j), (i, j + shift)]
                .map(|(i, j)| ENCODE(intensity(&evidence.camera.ray(i, j))))
        });
        range_with_margin(colours.as_flattened(), 1)
    }))
}

/// Rays that go through the pixels half a pixel or a whole one beside their middles.
pub(crate) fn shifted_ray_candidates(evidence: &Evidence) -> impl Iterator<Item = Explanation<'_>> {
    evidence.step.into_iter().flat_map(move |step| {
        let halves = [-1.0, -0.5, 0.0, 0.5, 1.0];
        let shifts = halves.into_iter().flat_map(move |u| halves.map(|v| (u, v)));
        let shifts = shifts.filter(|place| *place != (0.0, 0.0));
        shifts.map(move |(u, v)| {
            let intensity = intensity_function(step, &scene_of_step(step));
            let sentence = format!(
                "Your rays do not go through the middles of the pixels, but through i {} and \
                 j {}.",
                format_sign_and_number(u),
                format_sign_and_number(v)
            );
            Explanation::exact(sentence, &[CAMERA, RENDER], move |pixel| {
                let (i, j) = (f64::from(pixel.i) + u, f64::from(pixel.j) + v);
                ENCODE(intensity(&evidence.camera.ray(i, j)))
            })
        })
    })
}

fn format_sign_and_number(shift: f64) -> String {
    let sign = if shift < 0.0 { '−' } else { '+' };
    format!("{sign} {}", shift.abs())
}

/// The side of the squares in which means are compared: that of a JPEG's.
const SQUARE: u32 = 16;

/// How far a mean over a square may be off.
const MEAN: u64 = 14;

/// Ours, a little off everywhere: in each small square the mean is about ours, and what
/// differs there is brighter as often as darker.
pub(crate) fn lossy_candidate(evidence: &Evidence) -> Option<Explanation<'_>> {
    evidence.step?;
    let (wrong, all) = (evidence.wrong_pixels().len(), evidence.pixels.len());
    let (wrong_sky, sky) = evidence.count_wrong_and_all(|pixel| pixel.is_sky());
    if wrong < all / 100 || wrong_sky < sky / 100 {
        return None;
    }
    let mut squares: HashMap<(u32, u32), ([i64; 3], u64)> = HashMap::new();
    let mut distance = 0;
    for pixel in &evidence.pixels {
        let square = (pixel.i / SQUARE, pixel.j / SQUARE);
        let (sums, count) = squares.entry(square).or_default();
        for (k, sum) in sums.iter_mut().enumerate() {
            let difference = i64::from(pixel.yours[k]) - i64::from(pixel.ours[k]);
            *sum += difference;
            distance += difference.unsigned_abs();
        }
        *count += 1;
    }
    // The squares at the end of a row may be thin.
    let is_like_ours = squares
        .values()
        .all(|(sums, count)| sums.iter().all(|sum| sum.unsigned_abs() <= MEAN * (*count).max(128)));
    let sums = squares.values().flat_map(|(sums, _)| sums);
    let bias: u64 = sums.map(|sum| sum.unsigned_abs()).sum();
    if !is_like_ours || 3 * distance < 5 * bias {
        return None;
    }
    let sentence = format!(
        "Your picture is ours, a little off in {wrong} of {all} pixels, and in each small \
         square about as bright, as where it was packed with loss (JPEG, WebP), blurred, or \
         scaled and scaled back, or something random was added. Give the file that the \
         program wrote."
    );
    Some(Explanation::within_range(sentence, &[], |_| [[0; 3], [255; 3]]))
}
