//! The faults in a chapter, and the error that lists faults and stops a build.

use crate::replace_between::MissingEnd;
use anyhow::Chain;
use math_core::LatexError;
use std::fmt::{self, Display, Formatter};
use std::io;
use thiserror::Error;

/// An error on one line of a chapter, for the author to fix.
#[derive(Debug)]
pub struct Fault {
    /// The line, counted from 1.
    pub line: usize,
    /// The error on that line.
    pub error: ChapterError,
}

/// Writes the line, the error, and the error's causes.
impl Display for Fault {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{}", self.line)?;
        Chain::new(&self.error).try_for_each(|error| write!(f, ": {error}"))
    }
}

/// The errors that a directive, formula, picture, listing or box can have.
#[derive(Debug, Error)]
pub enum ChapterError {
    #[error(transparent)]
    MissingEnd(#[from] MissingEnd),
    #[error("there is no directive {0}")]
    UnknownDirective(String),
    #[error("{0} isn't allowed here: most directives need a paragraph or a fence of their own")]
    MisplacedDirective(String),

    #[error("there is no value {0}")]
    UnknownValue(String),
    #[error("there is no figure {0}")]
    UnknownFigure(String),
    #[error("there is no interactive figure {0}")]
    UnknownInteractiveFigure(String),
    #[error("there is no editable scene {0}")]
    UnknownEditableScene(String),
    #[error("there is no step {0}")]
    UnknownStep(String),
    #[error("there is no locked picture {0}")]
    UnknownLockedPicture(String),
    #[error("there is no picture {0}")]
    UnknownPicture(String),
    #[error("{0}, the picture of a listed mistake, isn't drawn yet: run `cargo xtask`")]
    UndrawnMistake(String),

    #[error("the picture {0} has no alt text: say what it shows")]
    MissingAltText(String),
    #[error("the alt text of {0} can't have directives in it")]
    DirectiveInAltText(String),
    #[error(
        "{{{{#pixel-panel {0}}}}} is not below a picture with {{{{#live {0}}}}} that has a probe"
    )]
    PanelWithoutPicture(String),
    #[error("the picture {0} has no {{{{#pixel-panel {0}}}}} below it")]
    MissingPanel(&'static str),
    #[error("rows have the form {{{{#rows PICTURE COLUMN COLUMN …}}}}")]
    RowsForm,
    #[error("the picture {0} has no rows")]
    NoRows(String),

    #[error(
        "a lone $: write \\$ for a dollar sign; a formula needs a second $, braces in pairs, and \
         no HTML around it"
    )]
    LoneDollar,
    #[error("a lone $: a formula needs a $ at each end")]
    LoneDollarInWords,
    #[error("{0} can't be used in a formula")]
    DirectiveInFormula(String),
    #[error("the number {0} can't be used in this part of a formula")]
    NumberInFormula(String),
    #[error("{0} can't be used in code")]
    NumberInCode(String),
    #[error("a formula has at most {0} commands and braces")]
    LongFormula(usize),
    /// A formula that can't be parsed. `source` says why, or is None if the parser panicked.
    #[error("the formula {latex} can't be parsed")]
    Formula { latex: String, source: Option<Box<LatexError>> },

    #[error("a listing has to come from a file: write one {{{{#include path}}}} and nothing else")]
    CodeNotIncluded,
    #[error("the file {path} can't be read")]
    UnreadableFile { path: String, source: io::Error },
    #[error("{0} isn't a part of a file: write BEGIN..END, the first words of two lines")]
    PartForm(String),
    #[error("there is no such part of the file: no line begins with {0:?}")]
    UnknownLine(String),
    #[error("a console needs one of the marks `ours`, `yours`, `yours,refused` and `yours,fails`")]
    ConsoleForm,

    #[error(
        "a note has to follow the block that it belongs to: a paragraph, a list, a table, a listing, \
         a picture or a figure"
    )]
    NoteWithoutBlock,

    #[error("a box can't hold another box")]
    BoxInBox,
    #[error("the box has no {{{{#end}}}}")]
    MissingEndOfBox,
    #[error("{{{{#end}}}} has no box to end")]
    EndWithoutBox,
    #[error("a problem begins with {{{{#problem NUMBER ANSWER}}}}, where both words are numbers")]
    ProblemForm,
    #[error("a problem can't be inside a box or another problem")]
    ProblemInBox,
    #[error("the problem has no {{{{#answer}}}}")]
    MissingAnswer,
    #[error("a problem has at most {0} words")]
    LongProblem(usize),
    #[error("this is nested too deeply")]
    DeepNesting,
}

/// The result of expanding part of a chapter.
pub type ChapterResult<T> = Result<T, ChapterError>;

/// The error that stops a build. This error lists all faults that one check has found, with one
/// sentence for each fault.
#[derive(Debug, Error)]
#[error("{}\nThe book was not built.", .0.join("\n"))]
pub struct Faults(Vec<String>);

impl Faults {
    /// Returns an error that lists all these faults, or Ok if `faults` is empty.
    pub fn ensure_none(faults: impl IntoIterator<Item = impl Display>) -> Result<(), Self> {
        let sentences: Vec<_> = faults.into_iter().map(|fault| fault.to_string()).collect();
        if sentences.is_empty() { Ok(()) } else { Err(Self(sentences)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fault_is_displayed_with_its_line_error_and_cause() {
        let source = io::Error::other("a cause");
        let error = ChapterError::UnreadableFile { path: "a.rs".to_owned(), source };
        let fault = Fault { line: 3, error };
        assert_eq!(fault.to_string(), "3: the file a.rs can't be read: a cause");
    }

    #[test]
    fn faults_are_listed_and_an_empty_list_is_ok() {
        assert!(Faults::ensure_none([""; 0]).is_ok());
        let error = Faults::ensure_none(["a", "b"]).expect_err("there are two faults");
        assert_eq!(error.to_string(), "a\nb\nThe book was not built.");
    }
}
