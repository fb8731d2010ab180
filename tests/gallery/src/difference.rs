use image::{GenericImage, Rgb, RgbImage};
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
        /// Its colours, locked and new.
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
            largest: differ.iter().map(|((_, _, a), b)| apart(a, b)).max()?,
            first: (i, j),
            colours: (a.0, b.0),
        })
    }

    /// The locked picture, the new one, and where they differ, side by side.
    ///
    /// Equal pixels are black; the others are red, the brighter the farther apart, and
    /// brightest where only one of the two has a pixel.
    pub fn picture(locked: &RgbImage, new: &RgbImage) -> RgbImage {
        let (width, height) =
            (locked.width().max(new.width()), locked.height().max(new.height()));
        let mut panels = RgbImage::new(3 * width, height);
        let _ = panels.copy_from(locked, 0, 0);
        let _ = panels.copy_from(new, width, 0);
        for (i, j) in (0..width).flat_map(|i| (0..height).map(move |j| (i, j))) {
            let far = match [locked, new].map(|one| one.get_pixel_checked(i, j)) {
                [Some(a), Some(b)] => apart(a, b),
                [None, None] => 0,
                _ => 255,
            };
            if 0 < far {
                let red = Rgb([far.saturating_add(80), far / 2, far / 4]);
                panels.put_pixel(2 * width + i, j, red);
            }
        }
        panels
    }
}

/// How far apart two colours are in the channel that differs most.
pub(crate) fn apart(a: &Rgb<u8>, b: &Rgb<u8>) -> u8 {
    a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

impl Display for Difference {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Size((w, h), (new_w, new_h)) => {
                write!(
                    f,
                    "the picture is {new_w}×{new_h} pixels, the locked one {w}×{h}"
                )
            }
            Self::Pixels { count, largest, first: (i, j), colours: (a, b) } => {
                write!(
                    f,
                    "{count} pixels differ from the locked picture, by up to {largest} of 255; \
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
    fn equal_pictures_have_no_difference() {
        let picture = RgbImage::from_fn(4, 3, |i, j| Rgb([i as u8, j as u8, 7]));
        assert_eq!(Difference::between(&picture, &picture.clone()), None);
    }

    #[test]
    fn one_pixel_off_by_one_is_found_and_told() {
        let locked = RgbImage::from_pixel(4, 3, Rgb([9, 9, 9]));
        let mut new = locked.clone();
        new.put_pixel(2, 1, Rgb([9, 8, 9]));
        let found = Difference::between(&locked, &new).expect("they differ");
        assert_eq!(
            found.to_string(),
            "1 pixels differ from the locked picture, by up to 1 of 255; the first is in \
             column 2, row 1: locked [9, 9, 9], now [9, 8, 9]"
        );
        let picture = Difference::picture(&locked, &new);
        let red = picture
            .enumerate_pixels()
            .filter(|(.., p)| 80 <= p[0])
            .map(|(i, j, _)| (i, j));
        assert_eq!(red.collect::<Vec<_>>(), [(10, 1)]);
    }

    #[test]
    fn sizes_are_compared_first() {
        let found = Difference::between(&RgbImage::new(4, 3), &RgbImage::new(2, 3));
        assert_eq!(found, Some(Difference::Size((4, 3), (2, 3))));
    }

    #[test]
    fn what_only_one_of_them_has_is_marked() {
        let (tall, wide) = (RgbImage::new(2, 3), RgbImage::new(4, 1));
        let is_marked = |(i, j)| (i < 2) != (j < 1);
        for (locked, new) in [(&tall, &wide), (&wide, &tall)] {
            let picture = Difference::picture(locked, new);
            for (i, j, pixel) in picture.enumerate_pixels().filter(|p| 8 <= p.0) {
                assert_eq!(pixel[0] == 255, is_marked((i - 8, j)), "{i}, {j}");
            }
        }
    }
}
