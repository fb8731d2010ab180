use crate::comparison::{Comparison, Pixel};
use crate::facts::{FIRST_PIXELS, Fact, fact};
use course::Step;
use std::collections::BTreeSet;

/// How many values of a byte have to be others before a file is named for them.
const CURVE_VALUES: usize = 16;

/// The least black pixels that count as a rectangle which nothing draws, if it has no whole
/// rows or columns.
const RECTANGLE_PIXELS: u32 = 1000;

/// Facts about bytes alone.
pub(crate) fn byte_facts<'a>(comparison: &'a Comparison) -> [Fact<'a>; 9] {
    let grey_of = |channel: usize, name: &str| {
        fact("grey", 1, format!("has our {name} in all three bytes"), move |one| {
            one.yours == [one.ours[channel]; 3]
        })
    };
    let is_beside = |one: &Pixel, (di, dj): (i32, i32)| {
        let place = one.place.0.checked_add_signed(di).zip(one.place.1.checked_add_signed(dj));
        let neighbour = place.and_then(|(i, j)| comparison.ours.get_pixel_checked(i, j));
        neighbour.is_some_and(|neighbour| neighbour.0 == one.yours)
    };
    [
        grey_of(0, "red"),
        grey_of(1, "green"),
        grey_of(2, "blue"),
        fact("grey", 1, "is black", |one| one.yours == [0; 3]),
        fact("grey", 1, "is grey", |one| one.yours == [one.yours[0]; 3]),
        fact("brightness", 1, "is off by 1 of 255", |one| one.largest_difference() == 1),
        fact("neighbour", 1, "has the colour of a neighbour in ours", move |one| {
            (0..9).any(|k| is_beside(one, (k % 3 - 1, k / 3 - 1)))
        }),
        fact("brightness", 1, "is darker than ours", |one| {
            one.yours != [0; 3] && (0..3).all(|k| one.yours[k] <= one.ours[k])
        }),
        fact("brightness", 1, "is brighter than ours", |one| {
            (0..3).all(|k| one.ours[k] <= one.yours[k])
        }),
    ]
}

/// A sentence about black pixels that fill all crossings of some rows and columns, as those do
/// that nothing draws.
pub(crate) fn black_block(comparison: &Comparison) -> Option<String> {
    let black = comparison.wrong_pixels().iter().filter(|one| one.yours == [0; 3]);
    let columns: BTreeSet<_> = black.clone().map(|one| one.place.0).collect();
    let rows: BTreeSet<_> = black.clone().map(|one| one.place.1).collect();
    let (width, height) = comparison.ours.dimensions();
    let [wide, high] = [columns.len() as u32, rows.len() as u32];
    let span = |numbers: &BTreeSet<u32>| Some(numbers.last()? - numbers.first()? + 1);
    let count = black.count() as u32;
    let is_rectangle = RECTANGLE_PIXELS < count && span(&columns)? * span(&rows)? == count;
    if count != wide * high || !(wide == width || high == height || is_rectangle) {
        return None;
    }
    let file = match comparison.drawing {
        Some(_) => " Pixels are drawn in steps/step01_rays/src/draw_pixels.rs.",
        None => "",
    };
    let (columns, rows) = (format_numbers("column", &columns)?, format_numbers("row", &rows)?);
    Some(format!("{count} pixels are black, as if never drawn: {columns} of {rows}.{file}"))
}

/// Such as `row 3`, `rows 3 to 9`, or `4 rows from 3 to 9`.
fn format_numbers(word: &str, numbers: &BTreeSet<u32>) -> Option<String> {
    let (first, last, count) = (numbers.first()?, numbers.last()?, numbers.len() as u32);
    Some(match last - first + 1 {
        1 => format!("{word} {first}"),
        span if span == count => format!("{word}s {first} to {last}"),
        _ => format!("{count} {word}s from {first} to {last}"),
    })
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
        let bytes = comparison.pixels.iter().take(count).flat_map(|pixel| {
            let intensity = drawing.colour(&pixel.ray).to_array();
            (0..3).map(move |k| (intensity[k], pixel.yours[k], pixel.ours[k]))
        });
        let mut bytes: Vec<_> = bytes.collect();
        bytes.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let is_curve = |is_meant: fn(u8, u8) -> bool| {
            let mut pairs = bytes.iter().zip(&bytes[1..]);
            pairs.all(|((i, a, _), (j, b, _))| if i == j { a == b } else { is_meant(*a, *b) })
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
    let points = points.collect::<Vec<_>>().join(", ");
    let values: BTreeSet<_> = off.iter().map(|one| one.1).collect();
    // In steps 1 and 2 other colours of the directions look the same.
    let is_file_known = CURVE_VALUES <= values.len() && Step::Sphere < drawing.step;
    let file =
        if is_file_known { " Compare rgb8.rs and the mean in render.rs of step 1." } else { "" };
    Some(format!("Each byte follows from our intensity alone: {points}.{file}"))
}
