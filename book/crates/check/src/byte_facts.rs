use crate::comparison::{Comparison, Pixel};
use crate::facts::{FIRST_PIXELS, Fact, fact};
use course::Step;
use std::collections::BTreeSet;

/// How many values of a byte have to be others before a file is named for them.
const CURVE_VALUES: usize = 16;

/// Facts about bytes alone.
pub(crate) fn byte_facts<'a>(comparison: &'a Comparison) -> Vec<Fact<'a>> {
    let neighbour = |pixel: &Pixel, di: i32, dj: i32| {
        let place = pixel.place.0.checked_add_signed(di).zip(pixel.place.1.checked_add_signed(dj));
        place.and_then(|(i, j)| comparison.ours.get_pixel_checked(i, j)).map(|one| one.0)
    };
    let mut facts: Vec<_> = ["red", "green", "blue"]
        .into_iter()
        .enumerate()
        .map(|(channel, name)| {
            fact("grey", 1, format!("has our {name} in all three bytes"), move |one| {
                one.yours == [one.ours[channel]; 3]
            })
        })
        .collect();
    facts.extend([
        fact("grey", 1, "is black", |one| one.yours == [0; 3]),
        fact("grey", 1, "is grey", |one| one.yours == [one.yours[0]; 3]),
        fact("brightness", 1, "is off by 1 of 255", |one| one.largest_difference() == 1),
        fact("neighbour", 1, "has the colour of a neighbour in ours", move |one| {
            let mut around = (0..9).map(|k| (k % 3 - 1, k / 3 - 1));
            around.any(|(di, dj)| neighbour(one, di, dj) == Some(one.yours))
        }),
        fact("brightness", 1, "is darker than ours", |one| {
            one.yours != [0; 3] && (0..3).all(|k| one.yours[k] <= one.ours[k])
        }),
        fact("brightness", 1, "is brighter than ours", |one| {
            (0..3).all(|k| one.ours[k] <= one.yours[k])
        }),
    ]);
    facts
}

/// A sentence about black pixels that fill whole rows, columns or a rectangle, as those do that
/// nothing draws.
pub(crate) fn black_block(comparison: &Comparison) -> Option<String> {
    let (width, height) = comparison.ours.dimensions();
    let black = comparison.wrong_pixels().iter().filter(|one| one.yours == [0; 3]);
    let columns: BTreeSet<_> = black.clone().map(|one| one.place.0).collect();
    let rows: BTreeSet<_> = black.clone().map(|one| one.place.1).collect();
    let [left, right, top, low] =
        [columns.first()?, columns.last()?, rows.first()?, rows.last()?].map(|one| *one);
    let (count, [wide, high]) = (black.count(), [columns.len(), rows.len()].map(|n| n as u32));
    if count as u32 != wide * high {
        return None;
    }
    let shape = if wide == width {
        format!("{high} whole row{} from row {top} on", if high == 1 { "" } else { "s" })
    } else if high == height {
        format!("{wide} whole column{} from column {left} on", if wide == 1 { "" } else { "s" })
    } else if 1000 < count && (wide, high) == (right - left + 1, low - top + 1) {
        format!("a rectangle, columns {left} to {right} of rows {top} to {low}")
    } else {
        return None;
    };
    let file = match comparison.drawing {
        Some(_) => " Pixels are drawn in steps/step01_rays/src/draw_pixels.rs.",
        None => "",
    };
    Some(format!("{count} pixels are black, as if never drawn: {shape}.{file}"))
}

/// A sentence about bytes that follow from our intensity alone, and grow or fall with it.
pub(crate) fn byte_curve(comparison: &Comparison) -> Option<String> {
    let drawing = comparison.drawing?;
    let wrong = comparison.wrong_pixels();
    let wrong_sky = wrong.iter().filter(|one| one.is_sky()).count();
    // Where the sky or the objects alone are others, their colours are.
    if Step::Rays < drawing.step && [0, wrong.len()].contains(&wrong_sky) {
        return None;
    }
    let curve = |count: usize| {
        let pixels = comparison.pixels.iter().take(count);
        let bytes = pixels.flat_map(|pixel| {
            let intensity = drawing.colour(&comparison.ray(pixel)).to_array();
            (0..3).map(move |k| (intensity[k], pixel.yours[k], pixel.ours[k]))
        });
        let mut bytes: Vec<_> = bytes.collect();
        bytes.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let is_curve = |is_meant: fn(u8, u8) -> bool| {
            bytes.windows(2).all(|two| {
                let [(i, a, _), (j, b, _)] = [two[0], two[1]];
                if i == j { a == b } else { is_meant(a, b) }
            })
        };
        (is_curve(|a, b| a <= b) || is_curve(|a, b| b <= a)).then_some(bytes)
    };
    curve(FIRST_PIXELS)?;
    let curve = curve(comparison.pixels.len())?;
    let off: Vec<_> = curve.iter().filter(|(_, yours, ours)| yours != ours).collect();
    let mut points = [1, 3, 5].map(|part| off[part * off.len() / 6]).to_vec();
    points.dedup();
    let points = points.into_iter();
    let points = points.map(|(i, yours, ours)| format!("{i:.3} becomes {yours} (ours: {ours})"));
    let points: Vec<_> = points.collect();
    let values: BTreeSet<_> = off.iter().map(|one| one.1).collect();
    // In steps 1 and 2 other colours of the directions look the same.
    let is_file_known = CURVE_VALUES <= values.len() && Step::Sphere < drawing.step;
    let file =
        if is_file_known { " Compare rgb8.rs and the mean in render.rs of step 1." } else { "" };
    Some(format!("Each byte follows from our intensity alone: {}.{file}", points.join(", ")))
}
