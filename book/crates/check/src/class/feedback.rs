//! The verdict on a file that was handed in, and the sentence that helps the student most.

use crate::answer::Cause;
use crate::class::student::PictureReport;
use crate::{Answer, CheckError, Verdict};

/// The verdict on a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileVerdict {
    /// The file was compared with a right picture.
    Compared(Verdict),
    /// The file can't be read, or isn't a picture.
    Unreadable,
}

impl FileVerdict {
    /// The verdict in a word or two.
    pub fn label(self) -> &'static str {
        match self {
            Self::Compared(verdict) => verdict.label(),
            Self::Unreadable => "unreadable",
        }
    }
}

/// The verdict on a file, and a sentence about the file.
#[derive(Debug)]
pub(crate) struct Feedback {
    pub verdict: FileVerdict,
    /// Empty if the picture is right and there is nothing unusual about the file.
    pub sentence: String,
    /// The causes that we found. With any one of these changes, a right program draws exactly the
    /// student's picture.
    pub causes: Vec<Cause>,
}

impl Feedback {
    /// Whether the file earns the point for its picture.
    pub fn earns_point(&self) -> bool {
        matches!(self.verdict, FileVerdict::Compared(Verdict::Right | Verdict::OtherOptions))
    }
}

/// Judges a student's file. `earlier` contains the reports on the student's earlier pictures. If
/// the file and one of these pictures share a cause, the feedback's sentence names the cause and
/// the picture.
pub(crate) fn judge(result: &Result<Answer, CheckError>, earlier: &[PictureReport]) -> Feedback {
    let feedback = match result {
        Err(error) => Feedback {
            verdict: FileVerdict::Unreadable,
            sentence: error.to_string(),
            causes: vec![],
        },
        Ok(answer) if answer.verdict == Verdict::OtherOptions => {
            judge_picture_with_other_options(answer)
        }
        Ok(answer) => Feedback {
            verdict: FileVerdict::Compared(answer.verdict),
            sentence: answer.summary(),
            causes: answer.causes.clone(),
        },
    };
    match find_shared_cause(&feedback.causes, earlier) {
        Some((cause, picture)) => {
            let sentence = format!("The cause of a wrong {picture} explains this, too: {cause}.");
            Feedback { sentence, ..feedback }
        }
        None => feedback,
    }
}

/// Judges a picture that a right program draws with other options. The picture earns no point if a
/// listed mistake produces it, too. For example, a program with tan θ in place of tan(θ/2) draws
/// exactly the picture of `--fov 120`. A picture of one colour earns no point either, since many
/// options and mistakes produce such a picture.
fn judge_picture_with_other_options(answer: &Answer) -> Feedback {
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

/// Finds the first earlier picture that shares one of these causes. Returns the shared cause and
/// the name of the earlier picture.
fn find_shared_cause<'a>(
    causes: &'a [Cause],
    earlier: &[PictureReport],
) -> Option<(&'a Cause, &'static str)> {
    earlier.iter().find_map(|report| {
        let is_shared =
            |cause: &&Cause| report.files.iter().any(|file| file.feedback.causes.contains(cause));
        Some((causes.iter().find(is_shared)?, report.picture))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::answer::OptionDoubts;
    use crate::class::student::FileReport;
    use course::mistakes;

    fn answer(verdict: Verdict) -> Answer {
        Answer::new(verdict, "The headline.".to_owned())
    }

    fn feedback_on_other_options(doubts: OptionDoubts) -> Feedback {
        let answer = Answer { option_doubts: doubts, ..answer(Verdict::OtherOptions) };
        judge(&Ok(answer), &[])
    }

    #[test]
    fn right_picture_earns_its_point_and_has_no_sentence() {
        let right = judge(&Ok(answer(Verdict::Right)), &[]);
        assert!(right.earns_point() && right.sentence.is_empty());
        let wrong = judge(&Ok(answer(Verdict::NotRight)), &[]);
        assert!(!wrong.earns_point());
        assert_eq!(wrong.sentence, "The headline.");
    }

    #[test]
    fn other_options_earn_the_point_unless_something_else_may_give_the_picture() {
        let plain = feedback_on_other_options(OptionDoubts::default());
        assert!(plain.earns_point());
        assert_eq!(plain.sentence, "The headline.");
        let one_colour =
            feedback_on_other_options(OptionDoubts { is_one_colour: true, ..Default::default() });
        assert!(!one_colour.earns_point());
        assert_eq!(one_colour.sentence, "The headline.");
        let mistaken = feedback_on_other_options(OptionDoubts {
            mistakes: vec![&mistakes()[0]],
            ..Default::default()
        });
        assert!(!mistaken.earns_point());
        assert_eq!(
            mistaken.sentence,
            "Other options give this picture, and so does a mistake: the angle is in degrees \
             (steps/step01_rays/src/program.rs)."
        );
    }

    #[test]
    fn file_that_cannot_be_checked_is_unreadable() {
        let feedback = judge(&Err(CheckError::UnknownName), &[]);
        assert_eq!(feedback.verdict.label(), "unreadable");
        assert!(!feedback.earns_point());
    }

    #[test]
    fn cause_of_an_earlier_picture_is_named_again() {
        let wrong = |causes: &[&str]| {
            let causes = causes.iter().map(|cause| Cause::Camera((*cause).to_owned())).collect();
            Ok(Answer { causes, ..answer(Verdict::NotRight) })
        };
        let file = |result| FileReport {
            printable_path: "my.png".to_owned(),
            feedback: judge(&result, &[]),
            result,
        };
        let earlier = [PictureReport {
            picture: "step01_rays",
            is_counted: true,
            files: vec![file(Ok(answer(Verdict::Right))), file(wrong(&["a", "b"]))],
            file_count: 2,
        }];
        for (causes, sentence) in [
            (&["a", "c"][..], "The cause of a wrong step01_rays explains this, too: a."),
            (&["b"], "The cause of a wrong step01_rays explains this, too: b."),
            (&[], "The headline."),
        ] {
            assert_eq!(judge(&wrong(causes), &earlier).sentence, sentence);
        }
    }
}
