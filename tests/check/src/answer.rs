use image::RgbImage;

/// What `check` says, and its exit code.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// 0 if the picture is right, 1 if it is not, 2 if there is nothing to compare.
    pub code: u8,
    /// One sentence or several lines, of which the first says the most.
    pub text: String,
    /// The reader's picture, ours and the difference side by side, where they differ.
    pub difference: Option<RgbImage>,
}

impl Answer {
    /// An answer of words alone.
    pub fn new(code: u8, text: String) -> Self {
        Self { code, text, difference: None }
    }

    /// Why there is nothing to compare.
    pub(crate) fn refused(sentence: String) -> Self {
        Self::new(2, format!("error: {sentence}"))
    }
}
