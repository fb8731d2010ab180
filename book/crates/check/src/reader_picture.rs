//! The picture that a reader has drawn.

use crate::png_file::DecodedPng;
use course::{Mistake, find_mistakes_with_hash, hash_picture, hashes_of_right_pictures};
use image::RgbImage;
use std::cell::OnceCell;

/// The maximum number of pixels in a picture that we hash. Larger pictures can't be in the table of
/// hashes, because the pictures in this table are drawn with the default options.
const MAX_HASHED_PIXELS: usize = 1 << 20;

/// A reader's picture, which is hashed at most once.
pub(crate) struct ReaderPicture {
    pub rgb: RgbImage,
    /// Whether some pixels are not opaque. Such a picture can't be right.
    pub is_transparent: bool,
    /// One sentence for each unusual property of the file.
    pub file_notes: Vec<String>,
    hash: OnceCell<Option<u64>>,
}

impl ReaderPicture {
    pub fn new(DecodedPng { rgb, is_transparent, notes }: DecodedPng) -> Self {
        Self { rgb, is_transparent, file_notes: notes, hash: OnceCell::new() }
    }

    /// Returns the hash of the picture, or None if the picture is too large to be in the table of
    /// hashes.
    fn hash(&self) -> Option<u64> {
        *self.hash.get_or_init(|| {
            let is_small = self.rgb.pixels().len() <= MAX_HASHED_PIXELS;
            is_small.then(|| hash_picture(&self.rgb))
        })
    }

    /// Returns the name of the locked picture that equals this picture.
    pub fn find_equal_locked_picture(&self) -> Option<&'static str> {
        let hash = self.hash()?;
        hashes_of_right_pictures().find(|(_, locked)| *locked == hash).map(|(name, _)| name)
    }

    /// Finds the listed mistakes that produce this picture, likeliest first. Each mistake comes
    /// with the name of the picture that should have been drawn.
    pub fn find_mistakes(&self) -> Vec<(&'static Mistake, &'static str)> {
        self.hash().map(find_mistakes_with_hash).unwrap_or_default()
    }

    /// Finds the listed mistakes that produce this picture instead of the locked picture
    /// `target_name`.
    pub fn find_mistakes_for_target(&self, target_name: &str) -> Vec<&'static Mistake> {
        let mistakes = self.find_mistakes().into_iter();
        mistakes.filter(|(_, name)| *name == target_name).map(|(mistake, _)| mistake).collect()
    }
}
