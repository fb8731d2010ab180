//! Encodes pictures as PNG.

use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};

/// Encodes a picture as a PNG file with default compression. The best compression would take twice
/// as long, and make the file only 2 % smaller.
pub fn encode_png(picture: &RgbImage) -> Vec<u8> {
    let mut png = vec![];
    let (compression, filter) = (CompressionType::Default, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, compression, filter);
    picture.write_with_encoder(encoder).expect("a picture in memory can be encoded");
    png
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_holds_the_pixels() {
        let picture = RgbImage::from_fn(5, 3, |i, j| image::Rgb([i as u8, j as u8, 200]));
        let decoded =
            image::load_from_memory(&encode_png(&picture)).expect("the PNG file can be decoded");
        assert_eq!(decoded.into_rgb8(), picture);
    }
}
