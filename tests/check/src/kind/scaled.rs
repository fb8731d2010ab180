use crate::apart;
use crate::{Locked, Parts, Step, camera};
use image::RgbImage;
use image::imageops::{FilterType, resize, thumbnail};

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
    let drawn = [1, 2, 4].map(|samples| parts.picture(step, samples));
    all.iter().find(|scaled| is_nearer(yours, scaled, &drawn)).map(|_| {
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

/// Whether the picture is much nearer to the one that was scaled than to each that was
/// drawn, in the places where these differ.
fn is_nearer(yours: &RgbImage, scaled: &RgbImage, drawn: &[RgbImage; 3]) -> bool {
    let places = || {
        let ours = drawn[0].pixels();
        ours.zip(scaled.pixels()).map(|(ours, scaled)| 24 < apart(ours, scaled))
    };
    let off = |other: &RgbImage| -> u64 {
        let pairs = yours.pixels().zip(other.pixels()).zip(places());
        let edges = pairs.filter(|(_, is_edge)| *is_edge);
        edges.map(|((a, b), _)| u64::from(apart(a, b))).sum()
    };
    let least = drawn.iter().map(off).min().unwrap_or(0);
    off(scaled) * 10 < least * 7
}
