use crate::apart;
use crate::{Locked, Parts, Step, camera};
use image::imageops::{FilterType, resize, thumbnail};
use image::{Rgb, RgbImage};

/// Ways in which programs scale; another is the mean of the pixels that are covered.
///
/// Not the nearest pixel: that is what a camera draws that is off by half a pixel.
const FILTERS: [FilterType; 4] = [
    FilterType::Triangle,
    FilterType::CatmullRom,
    FilterType::Gaussian,
    FilterType::Lanczos3,
];

/// Says whether the picture is ours in another size, without having been drawn in it:
/// along the edges it is then nearer to ours, scaled, than to one that was drawn.
pub(super) fn told(yours: &RgbImage, ours: &Locked) -> Option<String> {
    let ((width, height), (w, h)) = (yours.dimensions(), ours.picture.dimensions());
    let step = Step::named(&ours.name)?;
    let all = u64::from(width) * u64::from(height);
    if (width, height) == (w, h) || width < 32 || height < 18 || 2_000_000 < all {
        return None;
    }
    let scaled = |filter| resize(&ours.picture, width, height, filter);
    let mut all: Vec<_> = vec![scaled(FILTERS[0])];
    // What is far from one of them is far from all.
    if is_far(yours, &all[0], 4) {
        return None;
    }
    all.extend(FILTERS.into_iter().skip(1).map(scaled));
    all.push(thumbnail(&ours.picture, width, height));
    all.retain(|scaled| !is_far(yours, scaled, 100));
    if all.is_empty() {
        return None; // It is not worth to draw ours.
    }
    let parts = Parts::right(&camera(width, height));
    let drawn = parts.picture(step, 1);
    let pixel = |samples, (i, j)| parts.pixel(step, samples, i, j);
    let is_it = |scaled: &&RgbImage| is_nearer(yours, scaled, &drawn, &pixel);
    all.iter().find(is_it).map(|_| {
        format!(
            "Not right yet: it was scaled. It is the picture of {}, {w}×{h} pixels, made \
             into {width}×{height}. Draw it in that size, or leave it as it is.",
            ours.name
        )
    })
}

/// Whether one of so many pixels, or more, is far from that of the other picture.
fn is_far(yours: &RgbImage, other: &RgbImage, one_of: usize) -> bool {
    let pairs = yours.pixels().zip(other.pixels());
    let far = pairs.filter(|(a, b)| 16 < apart(a, b)).count();
    yours.pixels().len() <= one_of * far
}

/// Whether the picture is much nearer to the one that was scaled than to each that may be
/// drawn, with more rays a pixel, too, in some of the places where these differ.
fn is_nearer(
    yours: &RgbImage,
    scaled: &RgbImage,
    drawn: &RgbImage,
    pixel: &dyn Fn(u32, (u32, u32)) -> Rgb<u8>,
) -> bool {
    let places = drawn.enumerate_pixels().map(|(i, j, _)| (i, j));
    let at = |all: &RgbImage, (i, j): (u32, u32)| *all.get_pixel(i, j);
    let differs =
        |place: &(u32, u32)| 24 < apart(&at(drawn, *place), &at(scaled, *place));
    let places: Vec<_> = places.filter(differs).collect();
    let places = || places.iter().step_by(places.len() / 4000 + 1).copied();
    let off = |other: &dyn Fn((u32, u32)) -> Rgb<u8>| -> u64 {
        places()
            .map(|place| u64::from(apart(&at(yours, place), &other(place))))
            .sum()
    };
    let least = [1, 2, 4].map(|samples| off(&|place| pixel(samples, place)));
    let least = least.into_iter().min().unwrap_or(0);
    off(&|place| at(scaled, place)) * 10 < least * 7
}
