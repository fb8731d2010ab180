use std::error::Error;
use std::fmt;

/// Something in a chapter that only its author can mend.
#[derive(Clone, Debug, PartialEq)]
pub struct Mistake {
    /// The chapter's file, as seen from the root of the workspace.
    pub file: String,
    /// The line in it, from 1.
    pub line: usize,
    /// What is wrong there, and what would be right.
    pub what: String,
}

/// Every mistake of the book, in the order of files and lines; it stops the build.
#[derive(Debug)]
pub struct Mistakes(pub Vec<Mistake>);

impl fmt::Display for Mistakes {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for Mistake { file, line, what } in &self.0 {
            writeln!(f, "{file}:{line}: {what}")?;
        }
        match self.0.len() {
            1 => write!(f, "The book is not built: one mistake."),
            many => write!(f, "The book is not built: {many} mistakes."),
        }
    }
}

impl Error for Mistakes {}
