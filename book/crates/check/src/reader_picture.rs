//! The picture that a reader has drawn.

use course::{Mistake, find_mistakes_with_hash, hash_picture, hashes_of_right_pictures};
use image::RgbImage;
use std::cell::OnceCell;

/// A picture with more pixels isn't hashed. All locked pictures are drawn with the default
/// options and are smaller, and so are those of the listed mistakes.
const MOST_HASHED_PIXELS: usize = 1 << 20;

/// A reader's picture, which is hashed once at most.
pub(crate) struct ReaderPicture {
    pub rgb: RgbImage,
    hash: OnceCell<Option<u64>>,
}

impl ReaderPicture {
    pub fn new(rgb: RgbImage) -> Self {
        Self { rgb, hash: OnceCell::new() }
    }

    /// The hash of the picture, or None if it is too large to be in a table.
    fn hash(&self) -> Option<u64> {
        *self.hash.get_or_init(|| {
            let is_small = self.rgb.pixels().len() <= MOST_HASHED_PIXELS;
            is_small.then(|| hash_picture(&self.rgb))
        })
    }

    /// The name of the locked picture that is equal to this one.
    pub fn find_equal(&self) -> Option<&'static str> {
        let hash = self.hash()?;
        hashes_of_right_pictures().find(|(_, locked)| *locked == hash).map(|(name, _)| name)
    }

    /// The listed mistakes that give this picture, each with the name of the picture that should
    /// have been drawn. The likeliest come first.
    pub fn find_mistakes(&self) -> Vec<(&'static Mistake, &'static str)> {
        self.hash().map(find_mistakes_with_hash).unwrap_or_default()
    }

    /// The listed mistakes that give this picture instead of the one of this name.
    pub fn find_mistakes_in(&self, name: &str) -> Vec<&'static Mistake> {
        let mistakes = self.find_mistakes().into_iter();
        mistakes.filter(|(_, drawn)| *drawn == name).map(|(mistake, _)| mistake).collect()
    }
}
