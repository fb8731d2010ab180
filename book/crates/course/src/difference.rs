use image::{Rgb, RgbImage};
use std::fmt::{Display, Formatter, Result};

/// How a new picture differs from the locked one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Difference {
    /// The sizes differ: (columns, rows) of the locked picture and of the new one.
    Size((u32, u32), (u32, u32)),
    /// The sizes are equal and some pixels differ.
    Pixels {
        /// How many.
        count: usize,
        /// How far apart a channel is at most, 1 to 255.
        largest: u8,
        /// Column and row of the first one, row by row.
        first: (u32, u32),
        /// Colours of the first one, locked and new.
        colours: ([u8; 3], [u8; 3]),
    },
}

impl Difference {
    /// None where the pictures are equal in every pixel.
    pub fn between(locked: &RgbImage, new: &RgbImage) -> Option<Self> {
        if locked.dimensions() != new.dimensions() {
            return Some(Self::Size(locked.dimensions(), new.dimensions()));
        }
        let pairs = locked.enumerate_pixels().zip(new.pixels());
        let differ: Vec<_> = pairs.filter(|((_, _, a), b)| a != b).collect();
        let &((i, j, a), b) = differ.first()?;
        Some(Self::Pixels {
            count: differ.len(),
            largest: differ.iter().map(|((_, _, a), b)| largest_channel_difference(a, b)).max()?,
            first: (i, j),
            colours: (a.0, b.0),
        })
    }
}

/// How far apart two colours are in the channel that differs most.
#[inline]
pub fn largest_channel_difference(a: &Rgb<u8>, b: &Rgb<u8>) -> u8 {
    a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

impl Display for Difference {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Size((w, h), (new_w, new_h)) => {
                write!(f, "the picture is {new_w}×{new_h} pixels, the locked one {w}×{h}")
            }
            Self::Pixels { count, largest, first: (i, j), colours: (a, b) } => {
                let differ = if *count == 1 { "pixel differs" } else { "pixels differ" };
                write!(
                    f,
                    "{count} {differ} from the locked picture, by up to {largest} of 255; \
                 the first is in column {i}, row {j}: locked {a:?}, now {b:?}"
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_pixel_off_by_one_is_described() {
        let locked = RgbImage::from_pixel(4, 3, Rgb([9, 9, 9]));
        let mut new = locked.clone();
        new.put_pixel(2, 1, Rgb([9, 8, 9]));
        let difference = Difference::between(&locked, &new).expect("they differ");
        assert_eq!(
            difference.to_string(),
            "1 pixel differs from the locked picture, by up to 1 of 255; the first is in \
             column 2, row 1: locked [9, 9, 9], now [9, 8, 9]"
        );
    }
}
