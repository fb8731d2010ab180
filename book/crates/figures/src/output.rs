use crate::Drawing;
use image::RgbImage;
use std::collections::BTreeMap;

/// A drawing, or the pixels of a picture.
pub enum Output {
    /// Lines and labels.
    Drawing(Drawing),
    /// Pixels.
    Pixels(RgbImage),
}

/// Numbers by name, formatted for the page; some are vectors or words.
pub type Numbers = BTreeMap<String, String>;

/// Numbers with these names.
pub fn collect_numbers<const N: usize>(numbers: [(&str, String); N]) -> Numbers {
    numbers.map(|(name, text)| (name.into(), text)).into()
}
