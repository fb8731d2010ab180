//! Reads a picture as a measurement of the program that drew it.

use crate::{Section, Step};
use image::RgbImage;

/// One stage of the way from a ray to a byte, and what the picture says of it.
pub struct Stage {
    /// What it is called.
    pub name: &'static str,
    /// Whether it is right.
    pub verdict: Verdict,
    /// Theirs and ours, in whole sentences.
    pub numbers: Vec<String>,
    /// The section of the book to go back to.
    pub section: Section,
    /// The function of `tests/by_hand.rs` that would show it.
    pub test: Option<&'static str>,
}

/// Whether a stage is right.
pub enum Verdict {
    /// Every pixel that it can be read from agrees.
    Right,
    /// The numbers show it.
    Wrong,
    /// It can't be told from this picture, and why.
    Unknown(String),
}

/// The stages of `step`, from the ray on.
pub fn stages(_yours: &RgbImage, _step: Step) -> Vec<Stage> {
    vec![]
}

/// One pixel in full.
pub fn pixel(_yours: &RgbImage, _ours: &RgbImage, _step: Step) -> String {
    String::new()
}
