//! What is wrong with a chapter or a page, and on which line: the sentences that stop a build.

use crate::replace_between::MissingEnd;
use anyhow::Chain;
use math_core::LatexError;
use std::fmt::{self, Display, Formatter};
use std::io;
use thiserror::Error;

/// What is wrong on one line of a chapter. Only the author can mend it.
#[derive(Debug)]
pub struct Fault {
    /// The line, counted from 1.
    pub line: usize,
    /// What is wrong there.
    pub error: ChapterError,
}

/// The line, the error, and its causes.
impl Display for Fault {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}", self.line)?;
        Chain::new(&self.error).try_for_each(|error| write!(f, ": {error}"))
    }
}

/// What can be wrong with a directive, a formula, a picture or a listing of a chapter.
#[derive(Debug, Error)]
pub enum ChapterError {
    #[error(transparent)]
    MissingEnd(#[from] MissingEnd),
    #[error(
        "{0} stands alone, in a paragraph or a fence of its own, or is none of the \
         directives"
    )]
    MisplacedDirective(String),

    #[error("there is no value {0}")]
    UnknownValue(String),
    #[error("there is no figure {0}")]
    UnknownFigure(String),
    #[error("nothing called {0:?} is interactive")]
    UnknownLive(String),
    #[error("nothing called {0:?} writes a program")]
    UnknownProgram(String),
    #[error("there is no step {0}")]
    UnknownStep(String),
    #[error("there is no locked picture {0}")]
    UnknownLockedPicture(String),
    #[error("there is no picture {0}")]
    UnknownPicture(String),
    #[error("{0}, of a listed mistake, isn't drawn yet: run `cargo xtask`")]
    UndrawnMistake(String),

    #[error("the picture {0} has no alt text: say what it shows")]
    MissingAltText(String),
    #[error("the alt text of {0} is words alone, without directives")]
    DirectiveInAltText(String),
    #[error(
        "{{{{#pixel-panel {0}}}}} is not below a picture with {{{{#live {0}}}}} that has a probe"
    )]
    PanelWithoutPicture(String),
    #[error("the picture {0} has no {{{{#pixel-panel {0}}}}} below it")]
    MissingPanel(&'static str),
    #[error("rows are {{{{#rows PICTURE COLUMN COLUMN …}}}}")]
    RowsForm,

    #[error(
        "a $ that is no formula is written \\$, and a formula has its end, pairs of braces, and \
         no HTML around it"
    )]
    LoneDollar,
    #[error("a lone $: a formula has two")]
    LoneDollarInWords,
    #[error("a formula has no {0}")]
    DirectiveInFormula(String),
    #[error("a formula can't have the number {0}")]
    NumberInFormula(String),
    #[error("code has no {0}")]
    NumberInCode(String),
    #[error("a formula has at most {0} commands and braces")]
    LongFormula(usize),
    /// A formula that the parser refuses, or one that it can't cope with.
    #[error("the formula {latex} does not parse")]
    Formula { latex: String, source: Option<Box<LatexError>> },

    #[error("code is from a file: a listing is one {{{{#include path}}}} and nothing else")]
    TypedCode,
    #[error("there is no file {path} that can be read")]
    UnreadableFile { path: String, source: io::Error },
    #[error("a part is ..how its end begins, or how it begins.., not {0}")]
    PartForm(String),
    #[error("no line there begins with {0:?}")]
    UnknownLine(String),
    #[error("a console is ours or yours, or yours,refused or yours,fails")]
    ConsoleForm,

    #[error("a box can't hold another box")]
    BoxInBox,
    #[error("the box has no {{{{#end}}}}")]
    MissingEndOfBox,
    #[error("{{{{#end}}}} without a box to end")]
    EndWithoutBox,
    #[error("a problem is {{{{#problem NUMBER ANSWER}}}}, two numbers")]
    ProblemForm,
    #[error("a problem begins after the {{{{#end}}}} of another")]
    ProblemInBox,
    #[error("the problem has no {{{{#answer}}}}")]
    MissingAnswer,
    #[error("a problem has at most {0} words")]
    LongProblem(usize),
    #[error("this is nested too deeply")]
    DeepNesting,
}

/// The result of expanding a part of a chapter.
pub type ChapterResult<T> = Result<T, ChapterError>;

/// Every fault of a book, a sentence each. They stop the build.
#[derive(Debug, Error)]
#[error("{}\nThe book is not done.", .0.join("\n"))]
pub struct Faults(Vec<String>);

impl Faults {
    /// Returns an error that holds all these faults, if there are any.
    pub fn ensure_none(faults: impl IntoIterator<Item = impl Display>) -> Result<(), Self> {
        let sentences: Vec<_> = faults.into_iter().map(|fault| fault.to_string()).collect();
        if sentences.is_empty() { Ok(()) } else { Err(Self(sentences)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fault_says_its_line_its_error_and_the_cause() {
        let source = io::Error::other("a cause");
        let error = ChapterError::UnreadableFile { path: "a.rs".to_owned(), source };
        let fault = Fault { line: 3, error };
        assert_eq!(fault.to_string(), "3: there is no file a.rs that can be read: a cause");
    }

    #[test]
    fn faults_are_listed_and_none_is_no_error() {
        assert!(Faults::ensure_none([""; 0]).is_ok());
        let error = Faults::ensure_none(["a", "b"]).expect_err("two faults");
        assert_eq!(error.to_string(), "a\nb\nThe book is not done.");
    }
}
