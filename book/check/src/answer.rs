use image::RgbImage;

/// Text and exit code of an answer of `check`.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// 0 if the picture is right, 1 if it is not, 2 if there is nothing to compare.
    pub code: u8,
    /// At most a dozen lines, of which the first says the most.
    pub text: String,
    /// The reader's picture, ours and the difference side by side, where they differ.
    pub difference: Option<RgbImage>,
}

impl Answer {
    /// An answer of words alone.
    pub fn new(code: u8, text: String) -> Self {
        Self { code, text, difference: None }
    }
}
