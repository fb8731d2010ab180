//! Describes the difference between two pictures in words.

use image::{Rgb, RgbImage};

/// Describes in one sentence how a new picture differs from the locked picture. Returns None if all
/// pixels are equal.
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

/// Returns how far apart two colours are in the channel in which they differ most.
#[inline]
pub fn largest_channel_difference(a: &Rgb<u8>, b: &Rgb<u8>) -> u8 {
    a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn difference_names_the_first_pixel_and_the_largest_difference() {
        let locked = RgbImage::from_pixel(3, 2, Rgb([10, 20, 30]));
        assert_eq!(describe_difference(&locked, &locked), None);
        let mut new = locked.clone();
        new.put_pixel(1, 0, Rgb([10, 25, 30]));
        let text = describe_difference(&locked, &new).expect("the pictures differ");
        assert!(text.starts_with("1 pixel differs from the locked picture, by up to 5 of 255"));
        assert!(text.ends_with("column 1, row 0: locked [10, 20, 30], now [10, 25, 30]"), "{text}");
        new.put_pixel(2, 1, Rgb([0, 20, 30]));
        let text = describe_difference(&locked, &new).expect("the pictures differ");
        assert!(text.starts_with("2 pixels differ from the locked picture, by up to 10"), "{text}");
    }

    #[test]
    fn pictures_of_two_sizes_are_distinguished_by_their_sizes() {
        let text = describe_difference(&RgbImage::new(4, 3), &RgbImage::new(2, 1));
        assert_eq!(text.as_deref(), Some("the picture is 2×1 pixels, the locked one 4×3"));
    }

    #[test]
    fn largest_difference_is_that_of_one_channel() {
        assert_eq!(largest_channel_difference(&Rgb([1, 9, 3]), &Rgb([3, 2, 3])), 7);
    }
}
