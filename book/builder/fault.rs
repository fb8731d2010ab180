use std::error::Error;
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

/// All faults at once, in the order of files and lines; they stop the build.
#[derive(Debug)]
pub struct Faults(Vec<Fault>);

impl Faults {
    /// An error if there are faults.
    pub fn check(faults: Vec<Fault>) -> Result<(), Self> {
        if faults.is_empty() { Ok(()) } else { Err(Self(faults)) }
    }
}

impl fmt::Display for Faults {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.iter().try_for_each(|fault| writeln!(f, "{fault}"))?;
        match self.0.len() {
            1 => write!(f, "The book is not done: one fault."),
            many => write!(f, "The book is not done: {many} faults."),
        }
    }
}

impl Error for Faults {}
