//! Hashes pictures, so that they can be recognised.

use crate::fnv_1a;
use image::RgbImage;

/// Hashes a picture: 64-bit FNV-1a of the number of columns, the number of rows and all bytes.
pub fn hash_picture(picture: &RgbImage) -> u64 {
    let (columns, rows) = picture.dimensions();
    let size = [columns, rows].into_iter().flat_map(u32::to_le_bytes);
    fnv_1a(size.chain(picture.as_raw().iter().copied()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hash_depends_on_the_size_and_on_each_byte() {
        let black = hash_picture(&RgbImage::new(2, 3));
        assert_eq!(black, hash_picture(&RgbImage::new(2, 3)));
        assert_ne!(black, hash_picture(&RgbImage::new(3, 2)));
        let mut picture = RgbImage::new(2, 3);
        picture[(1, 2)][2] = 1;
        assert_ne!(black, hash_picture(&picture));
    }
}
