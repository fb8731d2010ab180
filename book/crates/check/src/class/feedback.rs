//! The verdict on a file that was handed in, and the sentence that helps its student most.

use crate::answer::Cause;
use crate::class::student::PictureReport;
use crate::{Answer, CheckError, Verdict};

/// The verdict on a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileVerdict {
    /// The file was compared with a right picture.
    Compared(Verdict),
    /// The file can't be read, or is no picture.
    Unreadable,
}

impl FileVerdict {
    /// The verdict in a word or two.
    pub fn words(self) -> &'static str {
        match self {
            Self::Compared(verdict) => verdict.words(),
            Self::Unreadable => "unreadable",
        }
    }
}

/// A verdict, and a sentence about it.
pub(crate) struct Feedback {
    pub verdict: FileVerdict,
    /// Empty if all is right.
    pub sentence: String,
    /// Everything we know of that gives the picture.
    pub causes: Vec<Cause>,
}

impl Feedback {
    /// Whether the file deserves the point of its picture.
    pub fn has_point(&self) -> bool {
        matches!(self.verdict, FileVerdict::Compared(Verdict::Right | Verdict::OtherOptions))
    }
}

/// The feedback on a file of a student. In the table it comes below the `earlier` pictures.
pub(crate) fn judge(result: &Result<Answer, CheckError>, earlier: &[PictureReport]) -> Feedback {
    let feedback = match result {
        Err(error) => Feedback {
            verdict: FileVerdict::Unreadable,
            sentence: error.to_string(),
            causes: vec![],
        },
        Ok(answer) if answer.verdict == Verdict::OtherOptions => judge_options(answer),
        Ok(answer) => Feedback {
            verdict: FileVerdict::Compared(answer.verdict),
            sentence: answer.summary(),
            causes: answer.causes.clone(),
        },
    };
    match find_shared_cause(&feedback.causes, earlier) {
        Some((cause, picture)) => {
            let sentence = format!("What gives {picture} gives this, too: {cause}.");
            Feedback { sentence, ..feedback }
        }
        None => feedback,
    }
}

/// The feedback on a picture that other options give. It gets no point if a listed mistake gives
/// the same picture, as the tangent of θ in place of θ/2 is like `--fov 120`, nor if it has one
/// colour, which many options and mistakes give.
fn judge_options(answer: &Answer) -> Feedback {
    let doubts = &answer.option_doubts;
    let causes: Vec<_> = doubts.mistakes.iter().map(|mistake| Cause::Mistake(mistake)).collect();
    let is_doubtful = doubts.is_one_colour || !causes.is_empty();
    let verdict = if is_doubtful { Verdict::NotRight } else { Verdict::OtherOptions };
    let sentence = match causes.first() {
        Some(mistake) => {
            format!("Other options give this picture, and so does a mistake: {mistake}.")
        }
        None => answer.summary(),
    };
    Feedback { verdict: FileVerdict::Compared(verdict), sentence, causes }
}

/// The first of the causes that also gives an earlier picture, and the name of that picture.
fn find_shared_cause<'a>(
    causes: &'a [Cause],
    earlier: &[PictureReport],
) -> Option<(&'a Cause, &'static str)> {
    earlier.iter().find_map(|report| {
        let gives_it =
            |cause: &&Cause| report.files.iter().any(|file| file.feedback.causes.contains(cause));
        Some((causes.iter().find(gives_it)?, report.picture))
    })
}
