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

impl Output {
    /// The width and the height.
    pub fn width_and_height(&self) -> [f64; 2] {
        match self {
            Self::Drawing(drawing) => drawing.width_and_height(),
            Self::Pixels(image) => [image.width(), image.height()].map(f64::from),
        }
    }
}

impl From<Drawing> for Output {
    fn from(drawing: Drawing) -> Self {
        Self::Drawing(drawing)
    }
}

impl From<RgbImage> for Output {
    fn from(image: RgbImage) -> Self {
        Self::Pixels(image)
    }
}

/// Numbers by name, formatted for the page; some are vectors or words.
pub type Numbers = BTreeMap<String, String>;

/// Numbers with these names.
pub fn collect_numbers<const N: usize>(numbers: [(&str, String); N]) -> Numbers {
    numbers.map(|(name, text)| (name.into(), text)).into()
}
