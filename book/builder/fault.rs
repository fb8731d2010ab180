use anyhow::{Result, bail};
use std::fmt;

/// Something in the book that only its author can mend.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The chapter's file, as seen from the root of the workspace, or the page.
    pub file: String,
    /// The line in it, from 1.
    pub line: usize,
    /// What is wrong there, and what would be right.
    pub what: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file, self.line, self.what)
    }
}

/// An error that tells all faults at once, if there are any; it stops the build.
pub fn check(faults: &[Fault]) -> Result<()> {
    let all: String = faults.iter().map(|fault| format!("{fault}\n")).collect();
    match faults.len() {
        0 => Ok(()),
        1 => bail!("{all}The book is not done: one fault."),
        many => bail!("{all}The book is not done: {many} faults."),
    }
}
