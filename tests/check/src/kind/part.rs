use crate::Locked;
use image::RgbImage;

/// How many pixels of a row are looked for first.
const RUN: usize = 8;

/// Says whether the picture is a part of ours, or ours a part of it, to the last byte.
pub(super) fn told(yours: &RgbImage, ours: &Locked) -> Option<String> {
    let Locked { name, picture } = ours;
    let ((width, height), (w, h)) = (yours.dimensions(), picture.dimensions());
    if let Some((i, j)) = place(yours, picture) {
        return Some(format!(
            "Not right yet: it is cut out of the picture of {name}: its columns {i} to {} and rows {j} to \
             {}. The rest is missing.",
            i + width - 1,
            j + height - 1
        ));
    }
    let (i, j) = place(picture, yours)?;
    Some(format!(
        "Not right yet: it is a screenshot, or has a frame: the picture of {name} is in it, {w}×{h} of \
         {width}×{height} pixels, from column {i} and row {j} on. Take the file that the \
         program wrote."
    ))
}

/// The column and row of `large` where all of `small` begins.
fn place(small: &RgbImage, large: &RgbImage) -> Option<(u32, u32)> {
    let ((w, h), (width, height)) = (small.dimensions(), large.dimensions());
    let is_smaller = w <= width && h <= height && (w, h) != (width, height);
    if !is_smaller || w < 16 || h < 16 {
        return None;
    }
    let (u, v) = striking(small)?;
    let run = &row(small, v)[3 * u..3 * (u + RUN)];
    let is_here = |i: usize, j: u32| {
        let is_run = row(large, j + v)[3 * (i + u)..].starts_with(run);
        let same = |k: u32| row(large, j + k)[3 * i..].starts_with(row(small, k));
        is_run && (0..h).all(same)
    };
    let places = (0..=height - h)
        .flat_map(|j| (0..=(width - w) as usize).map(move |i| (i, j)));
    let (i, j) = places.into_iter().find(|&(i, j)| is_here(i, j))?;
    Some((i as u32, j))
}

/// The bytes of row `j`.
fn row(picture: &RgbImage, j: u32) -> &[u8] {
    let bytes = 3 * picture.width() as usize;
    &picture.as_raw()[j as usize * bytes..][..bytes]
}

/// Column and row of a run of pixels with as many colours as can be found; None where
/// all have one.
fn striking(picture: &RgbImage) -> Option<(usize, u32)> {
    let colours = |&(u, v): &(usize, u32)| {
        let run = &row(picture, v)[3 * u..3 * (u + RUN)];
        let mut all = vec![];
        for colour in run.chunks(3) {
            if !all.contains(&colour) {
                all.push(colour);
            }
        }
        all.len()
    };
    let columns = 0..=picture.width() as usize - RUN;
    let places = (0..picture.height())
        .step_by(5)
        .flat_map(|v| columns.clone().step_by(RUN).map(move |u| (u, v)));
    places.max_by_key(colours).filter(|place| 1 < colours(place))
}
