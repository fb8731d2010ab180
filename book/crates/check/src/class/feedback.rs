//! The verdict on a file that was handed in, and the sentence that helps its student most.

use crate::answer::Cause;
use crate::class::student::PictureReport;
use crate::{Answer, Verdict, read_png};
use course::{find_mistakes_with_hash, hash_picture};

/// The file whose mistakes are options of the program, such as another default.
const OPTIONS_FILE: &str = "steps/step01_rays/src/program.rs";

/// A verdict, and a sentence about it.
pub(crate) struct Feedback {
    pub verdict: Verdict,
    /// Empty if all is right.
    pub sentence: String,
}

impl Feedback {
    /// Whether the file deserves the point of its picture.
    pub fn has_point(&self) -> bool {
        matches!(self.verdict, Verdict::Right | Verdict::OtherOptions)
    }
}

/// The feedback on a file that should be a picture, below those of the student's `earlier`
/// pictures.
pub(crate) fn judge(
    answer: &Answer,
    file: &[u8],
    picture: &str,
    earlier: &[PictureReport],
) -> Feedback {
    if answer.verdict == Verdict::OtherOptions
        && let Some(mistake) = mistake_like_options(file, picture)
    {
        let sentence =
            format!("Other options give this picture, and so does a mistake: {mistake}.");
        return Feedback { verdict: Verdict::NotRight, sentence };
    }
    let sentence = match shared_cause(answer, earlier) {
        Some((cause, earlier)) => {
            format!("What gives {earlier} gives this, too: {}.", cause.words_and_file())
        }
        None => answer.feedback.clone(),
    };
    Feedback { verdict: answer.verdict, sentence }
}

/// A cause that also gives an earlier picture, and the name of that picture.
fn shared_cause<'a>(
    answer: &'a Answer,
    earlier: &[PictureReport],
) -> Option<(&'a Cause, &'static str)> {
    earlier.iter().find_map(|report| {
        let mut known = report.files.iter().flat_map(|file| &file.answer.causes);
        let cause = known.find_map(|known| answer.causes.iter().find(|cause| *cause == known))?;
        Some((cause, report.picture))
    })
}

/// A listed mistake that gives the same picture as other options do, such as the tangent of θ in
/// place of θ/2, which is like `--fov 120`.
fn mistake_like_options(file: &[u8], picture: &str) -> Option<String> {
    let yours = read_png(file).ok()?.rgb;
    let mistakes = find_mistakes_with_hash(hash_picture(&yours)).into_iter();
    let mut mistakes = mistakes.filter(|(_, name)| *name == picture).map(|(mistake, _)| mistake);
    let mistake = mistakes.find(|mistake| mistake.file != OPTIONS_FILE)?;
    Some(format!("{} ({})", mistake.title, mistake.file))
}
