use crate::largest_channel_difference;
use image::{GenericImage, Rgb, RgbImage};

const BRIGHTER: Rgb<u8> = Rgb([255, 140, 0]);
const DARKER: Rgb<u8> = Rgb([60, 140, 255]);
const WHITE: Rgb<u8> = Rgb([255; 3]);

/// Two pictures and where they differ, side by side.
///
/// In the third panel pixels that are equal are a dark grey; the others are orange where
/// the first picture is brighter, else blue, the brighter the farther apart, and so are
/// those that only one of them has. A pixel that is alone there has a frame around it.
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
    let mut panel = RgbImage::from_fn(width, height, colour);
    let places = isolated_difference_places(&panel);
    // Where very many are alone, frames would hide more than they show.
    if places.len() < 300 {
        places.into_iter().for_each(|place| draw_frame(&mut panel, place));
    }
    panel
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

/// Whether a pixel of the third panel is one that differs.
fn is_not_grey(pixel: &Rgb<u8>) -> bool {
    pixel.0 != [pixel[0]; 3]
}

/// The places that differ where at most two others do, five pixels around.
fn isolated_difference_places(panel: &RgbImage) -> Vec<(u32, u32)> {
    let is_isolated = |&(i, j, _): &(u32, u32, &Rgb<u8>)| {
        let rows = j.saturating_sub(5)..(j + 6).min(panel.height());
        let columns = i.saturating_sub(5)..(i + 6).min(panel.width());
        let around = rows.flat_map(|j| columns.clone().map(move |i| (i, j)));
        let mut others = around.filter(|&(i, j)| is_not_grey(panel.get_pixel(i, j)));
        others.nth(3).is_none()
    };
    let places = panel.enumerate_pixels().filter(|(.., pixel)| is_not_grey(pixel));
    places.filter(is_isolated).map(|(i, j, _)| (i, j)).collect()
}

/// Draws a square around a place, but for where it would hide a difference.
fn draw_frame(panel: &mut RgbImage, (i, j): (u32, u32)) {
    let side = || (0..11).map(|k| (k, 0)).chain((0..11).map(|k| (k, 10)));
    for (k, l) in side().chain(side().map(|(k, l)| (l, k))) {
        let place = (i + k).checked_sub(5).zip((j + l).checked_sub(5));
        let pixel = place.and_then(|(i, j)| panel.get_pixel_mut_checked(i, j));
        if let Some(pixel) = pixel.filter(|pixel| !is_not_grey(pixel)) {
            *pixel = WHITE;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_pixel_has_a_frame_and_the_colour_of_its_sign() {
        let locked = RgbImage::from_pixel(40, 30, Rgb([90, 90, 90]));
        for (byte, most) in [(91, 0), (89, 2)] {
            let mut new = locked.clone();
            new.put_pixel(20, 10, Rgb([90, byte, 90]));
            let panel = difference_panel(&new, &locked);
            let differ = panel.enumerate_pixels().filter(|(.., p)| is_not_grey(p));
            let differ: Vec<_> = differ.map(|(i, j, p)| (i, j, p.0)).collect();
            assert_eq!(differ.len(), 1);
            let (i, j, colour) = differ[0];
            assert_eq!((i, j), (20, 10));
            assert_eq!(colour.iter().max(), Some(&colour[most]));
            assert_eq!(panel.pixels().filter(|p| **p == WHITE).count(), 40);
        }
        assert!(difference_panel(&locked, &locked).pixels().all(|p| *p == Rgb([15; 3])));
    }

    #[test]
    fn pixels_of_one_picture_alone_are_marked() {
        let (tall, wide) = (RgbImage::new(2, 3), RgbImage::new(4, 1));
        for (first, second) in [(&tall, &wide), (&wide, &tall)] {
            for (i, j, pixel) in difference_panel(first, second).enumerate_pixels() {
                assert_eq!(is_not_grey(pixel), (i < 2) != (j < 1), "{i}, {j}");
            }
        }
    }
}
