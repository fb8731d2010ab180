//! What Rust would refuse of a text.

use std::ops::Range;

/// Fault in a text.
#[derive(Debug)]
pub struct Refusal {
    /// Letters of the text that are wrong.
    pub range: Range<usize>,
    /// One or two sentences for the reader; a list of names may follow, on a line of its own.
    pub sentence: String,
}

pub type Checked<T> = Result<T, Refusal>;

/// Refuses a part of a text.
pub fn refuse<T>(range: Range<usize>, sentence: impl Into<String>) -> Checked<T> {
    Err(Refusal { range, sentence: sentence.into() })
}
