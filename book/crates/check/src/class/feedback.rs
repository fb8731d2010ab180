//! The verdict on a file that was handed in, and the sentence that helps its student most.

use crate::answer::Cause;
use crate::class::student::PictureReport;
use crate::target::hash_if_small;
use crate::transformed::uniform_colour;
use crate::{Answer, Verdict, read_png};
use course::find_mistakes_with_hash;
use image::RgbImage;

/// The file whose mistakes are options of the program, such as another default.
const OPTIONS_FILE: &str = "steps/step01_rays/src/program.rs";

/// A verdict, and a sentence about it.
pub(crate) struct Feedback {
    pub verdict: Verdict,
    /// Empty if all is right.
    pub sentence: String,
    /// All that we know to give the picture, in words.
    pub causes: Vec<String>,
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
    let mut feedback = Feedback {
        verdict: answer.verdict,
        sentence: answer.feedback.clone(),
        causes: answer.causes.iter().map(Cause::words_and_file).collect(),
    };
    if answer.verdict == Verdict::OtherOptions
        && let Ok(yours) = read_png(file)
    {
        feedback.causes = mistakes_like_options(&yours.rgb, picture);
        if let Some(mistake) = feedback.causes.first() {
            feedback.sentence =
                format!("Other options give this picture, and so does a mistake: {mistake}.");
            feedback.verdict = Verdict::NotRight;
        } else if uniform_colour(&yours.rgb).is_some() {
            // Many options and mistakes give a picture of one colour.
            feedback.verdict = Verdict::NotRight;
        }
    }
    if let Some((cause, earlier)) = shared_cause(&feedback.causes, earlier) {
        feedback.sentence = format!("What gives {earlier} gives this, too: {cause}.");
    }
    feedback
}

/// One of the causes that also gives an earlier picture, and the name of that picture.
fn shared_cause<'a>(
    causes: &'a [String],
    earlier: &[PictureReport],
) -> Option<(&'a str, &'static str)> {
    earlier.iter().find_map(|report| {
        let known =
            |cause: &String| report.files.iter().any(|file| file.feedback.causes.contains(cause));
        Some((&**causes.iter().find(|cause| known(cause))?, report.picture))
    })
}

/// The listed mistakes that give the same picture as other options do, such as the tangent of θ in
/// place of θ/2, which is like `--fov 120`.
fn mistakes_like_options(yours: &RgbImage, picture: &str) -> Vec<String> {
    let mistakes = hash_if_small(yours).map(find_mistakes_with_hash).unwrap_or_default();
    let mistakes = mistakes.into_iter();
    let mistakes =
        mistakes.filter(|(mistake, name)| *name == picture && mistake.file != OPTIONS_FILE);
    mistakes.map(|(mistake, _)| format!("{} ({})", mistake.title, mistake.file)).collect()
}
