use crate::largest_channel_difference;
use image::{GenericImage, Rgb, RgbImage};

const BRIGHTER: Rgb<u8> = Rgb([255, 140, 0]);
const DARKER: Rgb<u8> = Rgb([60, 140, 255]);

/// Two pictures and where they differ, side by side.
///
/// In the third panel pixels that are equal are a dark grey; the others are orange where
/// the first picture is brighter, else blue, the brighter the farther apart, and so are
/// those that only one of them has.
pub fn draw_panels(first: &RgbImage, second: &RgbImage) -> RgbImage {
    let difference = difference_panel(first, second);
    let (width, height) = difference.dimensions();
    let mut panels = RgbImage::new(3 * width, height);
    for (panel, k) in [first, second, &difference].into_iter().zip(0..) {
        // It fits: a panel is as large as the largest of them.
        let _ = panels.copy_from(panel, k * width, 0);
    }
    panels
}

/// The third panel.
fn difference_panel(first: &RgbImage, second: &RgbImage) -> RgbImage {
    let width = first.width().max(second.width());
    let height = first.height().max(second.height());
    let pixels_at = |i, j| [first, second].map(|one| one.get_pixel_checked(i, j));
    let colour = |i, j| match pixels_at(i, j) {
        [Some(a), Some(b)] => difference_colour(a, b),
        [Some(_), None] => BRIGHTER,
        [None, Some(_)] => DARKER,
        [None, None] => Rgb([0; 3]),
    };
    RgbImage::from_fn(width, height, colour)
}

/// The colour that tells how two others differ.
fn difference_colour(a: &Rgb<u8>, b: &Rgb<u8>) -> Rgb<u8> {
    let sum = |colour: &Rgb<u8>| colour.0.iter().map(|c| u32::from(*c)).sum::<u32>();
    let strength = 120 + u32::from(largest_channel_difference(a, b)) * 135 / 255;
    let part = |c: u8| (u32::from(c) * strength / 255) as u8;
    match (a == b, sum(a) < sum(b)) {
        (true, _) => Rgb([(sum(b) / 18) as u8; 3]),
        (false, true) => Rgb(DARKER.0.map(part)),
        (false, false) => Rgb(BRIGHTER.0.map(part)),
    }
}
