//! A first picture, without rays: red increases to the right, green upwards.

use image::{ImageResult, Rgb, RgbImage};

/// The picture: each pixel has the colour of its column i and row j.
pub fn picture() -> RgbImage {
    RgbImage::from_fn(640, 360, |i, j| {
        let (right, up) = (f64::from(i) / 639.0, 1.0 - f64::from(j) / 359.0);
        Rgb([(255.0 * right) as u8, (255.0 * up) as u8, 160])
    })
}

fn main() -> ImageResult<()> {
    picture().save("gradient.png")
}
