//! The camera that a sky tells: where nothing is hit, red is 0.7 + 0.3 V_x and green 0.7 +
//! 0.3 V_y, and V is D_u i + D_v j + V_0. Each byte bounds a number of these.

use crate::comparison::{Budget, Comparison, Pixel};
use crate::drawing::Drawing;
use course::{Step, camera};
use std::mem::replace;

/// The cameras with one other number that give the reader's picture in every pixel, in words.
pub(crate) fn find_cameras(
    comparison: &Comparison,
    drawing: &Drawing,
    budget: &Budget,
) -> Vec<String> {
    let mut pixels: Vec<_> = comparison.pixels().collect();
    let mut words = vec![];
    for (row, k) in (0..2).flat_map(|row| (0..3).map(move |k| (row, k))) {
        let Some(number) = fit_number(comparison, row, k) else { continue };
        // Not the number is tried, but what is told of it.
        let number = (number * 1e12).round() / 1e12;
        let mut yours = camera();
        let old = replace(&mut yours.matrix.col_mut(k)[row], number);
        let ray = |pixel: &Pixel| yours.ray(pixel.place.0.into(), pixel.place.1.into());
        if budget.all(&mut pixels, 1, |pixel| drawing.bytes(&ray(pixel)) == pixel.yours) {
            let (axis, vector) = (["x", "y"][row], ["D_u", "D_v", "V_0"][k]);
            let clause = format!("{axis} of {vector} = {number} instead of {old:.6}");
            words.push(clause.replace('-', "−"));
        }
    }
    if drawing.step == Step::Rays && !words.is_empty() {
        words.push("other colours of the directions".into());
    }
    words
}

/// The number in this row of D_u, D_v or V_0 that gives all bytes of a channel where both
/// pictures show the sky, in which blue is 255; None where no number does, or ours.
fn fit_number(comparison: &Comparison, row: usize, k: usize) -> Option<f64> {
    let matrix = camera().matrix;
    let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
    for pixel in comparison.pixels().filter(|pixel| pixel.hit.is_none()) {
        let byte = f64::from(pixel.yours[row]);
        if pixel.yours[2] != 255 || !(1.0..255.0).contains(&byte) {
            continue;
        }
        let factor = f64::from([pixel.place.0, pixel.place.1, 1][k]);
        let other_terms = pixel.ray.direction[row] - factor * matrix.col(k)[row];
        let bound = |byte: f64| (byte / 255.0 - 0.7) / 0.3 - other_terms;
        let [low, high] = [bound(byte - 0.5), bound(byte + 0.5)];
        if 0.0 < factor {
            (least, most) = (least.max(low / factor), most.min(high / factor));
        }
        if most < least || factor == 0.0 && !(low..=high).contains(&0.0) {
            return None;
        }
    }
    let ours = matrix.col(k)[row];
    let pixel = if k == 2 { matrix.col(row)[row] } else { ours };
    let is_other = !(least..=most).contains(&ours);
    is_other.then(|| plain_number(least, most, [(0.0, 1.0), (0.0, ours), (ours, pixel)]))
}

/// The number between bounds that has the fewest digits when it is counted from a start in a
/// unit; the objects need it more exactly than the sky tells.
fn plain_number(least: f64, most: f64, starts_and_units: [(f64, f64); 3]) -> f64 {
    let middle = (least + most) / 2.0;
    let candidates = (0..8).flat_map(|digits| {
        let scale = 10_f64.powi(digits);
        starts_and_units
            .map(|(start, unit)| start + ((middle - start) / unit * scale).round() / scale * unit)
    });
    let mut plain = candidates.filter(|number| (least..=most).contains(number));
    plain.next().unwrap_or(middle)
}
