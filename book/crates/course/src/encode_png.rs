use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};

/// Encodes a picture as small as the encoder can, as pages show this very file.
pub fn encode_png(picture: &RgbImage) -> Vec<u8> {
    let mut png = vec![];
    let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
    let encoder = PngEncoder::new_with_quality(&mut png, best, filter);
    picture.write_with_encoder(encoder).expect("a picture in memory can be encoded");
    png
}
