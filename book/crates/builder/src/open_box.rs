//! The box or the problem that a chapter has begun, up to its `{{#end}}`.

use crate::problem::{OpenAnswer, OpenProblem};

/// A box or a problem whose `{{#end}}` hasn't been reached yet.
#[derive(Debug)]
pub enum OpenBox {
    /// A folded box, such as `{{#predict …}}`, that begins at this position in the chapter.
    Folded { start: usize },
    /// The panel of a picture. If the picture has no notes, there is a wrapper around both, which
    /// ends with the panel.
    Panel { start: usize, ends_wrapper: bool },
    /// A problem, up to its `{{#answer}}`.
    Problem(OpenProblem),
    /// The answer to a problem. One `{{#end}}` closes both.
    Answer(OpenAnswer),
}

impl OpenBox {
    /// The position in the chapter where it begins.
    pub fn start(&self) -> usize {
        match self {
            Self::Folded { start } | Self::Panel { start, .. } => *start,
            Self::Problem(problem) => problem.start,
            Self::Answer(answer) => answer.problem.start,
        }
    }
}
