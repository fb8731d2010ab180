//! Draws a side-by-side comparison of two pictures.

use crate::largest_channel_difference;
use image::{Rgb, RgbImage};

const BRIGHTER: Rgb<u8> = Rgb([255, 140, 0]);
const DARKER: Rgb<u8> = Rgb([60, 140, 255]);
const BLACK: Rgb<u8> = Rgb([0; 3]);

/// Draws two pictures and their difference, side by side.
///
/// In the third panel, equal pixels are dark grey. A pixel that differs is blue if the first
/// picture is darker at this pixel, and orange otherwise. The larger the difference, the brighter
/// the colour. If the pictures have different sizes, missing pixels are black.
pub fn draw_with_difference(first: &RgbImage, second: &RgbImage) -> RgbImage {
    let width = first.width().max(second.width());
    let height = first.height().max(second.height());
    RgbImage::from_fn(3 * width, height, |i, j| {
        let colour =
            |picture: &RgbImage| *picture.get_pixel_checked(i % width, j).unwrap_or(&BLACK);
        match i / width {
            0 => colour(first),
            1 => colour(second),
            _ => difference_colour(&colour(first), &colour(second)),
        }
    })
}

/// The colour of a pixel in the third panel. The pixel has the colour `a` in the first picture, and
/// the colour `b` in the second picture.
fn difference_colour(a: &Rgb<u8>, b: &Rgb<u8>) -> Rgb<u8> {
    let sum = |colour: &Rgb<u8>| colour.0.iter().map(|c| u32::from(*c)).sum::<u32>();
    let strength = 120 + u32::from(largest_channel_difference(a, b)) * 135 / 255;
    let scale = |c: u8| (u32::from(c) * strength / 255) as u8;
    match (a == b, sum(a) < sum(b)) {
        (true, _) => Rgb([(sum(b) / 18) as u8; 3]),
        (false, true) => Rgb(DARKER.0.map(scale)),
        (false, false) => Rgb(BRIGHTER.0.map(scale)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_are_the_two_pictures_and_their_difference() {
        let [dark, bright] = [Rgb([10, 10, 10]), Rgb([20, 200, 20])];
        let first = RgbImage::from_pixel(2, 1, bright);
        let second = RgbImage::from_fn(1, 1, |_, _| dark);
        let panels = draw_with_difference(&first, &second);
        assert_eq!(panels.dimensions(), (6, 1));
        let colours: Vec<_> = panels.pixels().copied().collect();
        assert_eq!(colours[..4], [bright, bright, dark, BLACK]);
    }

    #[test]
    fn difference_is_orange_blue_or_grey() {
        let [dark, bright] = [Rgb([0, 0, 0]), Rgb([255, 255, 255])];
        assert_eq!(difference_colour(&bright, &dark), BRIGHTER);
        assert_eq!(difference_colour(&dark, &bright), DARKER);
        let Rgb([red, green, blue]) = difference_colour(&bright, &bright);
        assert!(red == green && green == blue && red < 60);
    }
}
