//! How two pictures differ.

use image::{Rgb, RgbImage};

/// Says in a sentence how a new picture differs from the locked one. Returns None if all pixels are
/// equal.
pub fn describe_difference(locked: &RgbImage, new: &RgbImage) -> Option<String> {
    let ((w, h), (new_w, new_h)) = (locked.dimensions(), new.dimensions());
    if (w, h) != (new_w, new_h) {
        return Some(format!("the picture is {new_w}×{new_h} pixels, the locked one {w}×{h}"));
    }
    let pairs = locked.enumerate_pixels().zip(new.pixels());
    let differ: Vec<_> = pairs.filter(|((_, _, a), b)| a != b).collect();
    let ((i, j, a), b) = differ.first()?;
    let largest = differ.iter().map(|((_, _, a), b)| largest_channel_difference(a, b)).max()?;
    let count = match differ.len() {
        1 => "1 pixel differs".to_owned(),
        count => format!("{count} pixels differ"),
    };
    Some(format!(
        "{count} from the locked picture, by up to {largest} of 255; \
         the first is in column {i}, row {j}: locked {:?}, now {:?}",
        a.0, b.0
    ))
}

/// How far apart two colours are in the channel that differs most.
#[inline]
pub fn largest_channel_difference(a: &Rgb<u8>, b: &Rgb<u8>) -> u8 {
    a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}
