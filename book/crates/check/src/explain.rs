//! Explains how and why a picture differs from its target.

use crate::Verdict;
use crate::answer::{Cause, OptionDoubts, join_first};
use crate::camera_fit::describe_fitting_cameras;
use crate::changed_number::find_changed_numbers;
use crate::comparison::{Budget, Comparison};
use crate::facts::find_facts;
use crate::other_options::{Options, find_options};
use crate::reader_picture::ReaderPicture;
use crate::target::Target;
use crate::transformed::{describe_transformed, describe_uniform};
use crate::wrong_pixel::describe_most_different_pixel;
use course::{Mistake, Step};

/// The maximum number of causes that an answer names.
const MAX_CAUSES: usize = 3;

/// The maximum number of lines in a diff. Answers leave out longer diffs.
const MAX_DIFF_LINES: usize = 4;

/// The file whose code reads the program's options. A mistake in this code, such as a wrong
/// default, has the same effect as typing other options. So [`OptionDoubts`] leaves out the
/// mistakes in this file.
const OPTIONS_FILE: &str = "steps/step01_rays/src/program.rs";

/// A line for answers about exercises. We have no scenes for exercises, so we can't try out
/// options.
const EXERCISE_NOTE: &str =
    "Ours is drawn without options. With options, a right program may draw a different picture.";

const TEST_COMMAND: &str = "cargo test --no-fail-fast --test by_hand";

/// The maximum number of rays for trying out changes.
const MAX_RAYS: u32 = 4_000_000;

/// The parts of an answer that depend only on the pixels' colours. `check::compare` adds the notes
/// on the file, and takes the alpha channel into account.
pub(crate) struct Explanation {
    pub verdict: Verdict,
    /// The most helpful sentence.
    pub headline: String,
    /// The lines after the headline.
    pub details: Vec<String>,
    /// All changes we know of that reproduce this picture exactly.
    pub causes: Vec<Cause>,
    /// The line about the causes. None if there are no causes, or if this line is the headline.
    pub causes_line: Option<String>,
    pub option_doubts: OptionDoubts,
}

/// Compares a picture with the target. If they differ, explains how, and finds the known causes.
pub(crate) fn explain(yours: &ReaderPicture, target: &Target) -> Explanation {
    let title = &target.title;
    if yours.rgb == target.picture {
        return Explanation {
            verdict: Verdict::Right,
            headline: format!("This is {title}, in every pixel."),
            details: vec![],
            causes: vec![],
            causes_line: None,
            option_doubts: OptionDoubts::default(),
        };
    }
    let mistakes =
        target.name.as_ref().map(|name| yours.find_mistakes_for_target(name)).unwrap_or_default();
    let options = target.scene.as_ref().and_then(|scene| find_options(scene, &yours.rgb));
    // Hardly anybody types an angle with more than one decimal. So if the options need such an
    // angle and a listed mistake also fits, report the mistake instead of the options.
    if let Some(options) = &options
        && (options.has_at_most_one_decimal() || mistakes.is_empty())
    {
        return explain_picture_with_other_options(options, title, mistakes);
    }
    let comparison = Comparison::new(target, &yours.rgb);
    let equal_picture = yours.find_equal_locked_picture();
    let uniform = if equal_picture.is_none() { describe_uniform(&yours.rgb) } else { None };
    let whole_picture = match equal_picture {
        Some(name) => Some(format!("This is the picture of {name}, not {title}.")),
        None if uniform.is_some() => None,
        None => describe_transformed(&yours.rgb, &target.picture, title),
    };
    let mut causes: Vec<_> = mistakes.into_iter().map(Cause::Mistake).collect();
    if whole_picture.is_none() && uniform.is_none() {
        causes.extend(comparison.iter().flat_map(find_number_and_camera_causes));
    }
    let is_explained = whole_picture.is_some() || uniform.is_some() || !causes.is_empty();
    let says_size = comparison.is_none() && whole_picture.is_none();
    let size = says_size.then(|| {
        let ((w, h), (columns, rows)) = (yours.rgb.dimensions(), target.picture.dimensions());
        format!("Your picture is {w}×{h} pixels, and {title} {columns}×{rows}.")
    });
    let is_exercise = target.scene.is_none();
    let may_have_options =
        is_exercise && whole_picture.is_none() && (uniform.is_none() || says_size);
    let pixels = comparison.iter().flat_map(|comparison| {
        let facts = if is_explained { vec![] } else { find_facts(comparison) };
        describe_wrong_pixels(comparison, facts)
    });
    let described_causes = describe_causes(&causes, options.as_ref());
    let causes_line = whole_picture.as_ref().and(described_causes.first().cloned());
    // The line about the whole picture comes first, because it describes a difference that is plain
    // to see, such as a picture that is upside down. The causes come before the wrong pixels.
    let mut lines = whole_picture
        .into_iter()
        .chain(described_causes)
        .chain(size)
        .chain(uniform)
        .chain(pixels)
        .chain(may_have_options.then(|| EXERCISE_NOTE.to_owned()));
    let headline = lines.next().unwrap_or_else(|| format!("This isn't {title}."));
    let details = lines.collect();
    Explanation {
        verdict: Verdict::NotRight,
        headline,
        details,
        causes,
        causes_line,
        option_doubts: OptionDoubts::default(),
    }
}

/// Explains a picture that a right program draws with other options.
fn explain_picture_with_other_options(
    options: &Options,
    title: &str,
    mut mistakes: Vec<&'static Mistake>,
) -> Explanation {
    mistakes.retain(|mistake| mistake.file != OPTIONS_FILE);
    Explanation {
        verdict: Verdict::OtherOptions,
        headline: options.headline(title),
        details: Options::advice_on_default_options(),
        causes: vec![],
        causes_line: None,
        option_doubts: OptionDoubts { mistakes, is_one_colour: options.is_one_colour() },
    }
}

/// Tries out different numbers in the scene and different cameras, and returns the changes that
/// reproduce the whole picture. If the budget runs out, returns no changes at all, because the list
/// might be incomplete: an untried change might reproduce the picture, too.
fn find_number_and_camera_causes(comparison: &Comparison) -> Vec<Cause> {
    let Some(scene) = &comparison.target.scene else { return vec![] };
    let budget = Budget::new(MAX_RAYS);
    let numbers = find_changed_numbers(comparison, scene, &budget).into_iter();
    let cameras = describe_fitting_cameras(comparison, scene, &budget).into_iter();
    let causes = numbers.map(Cause::SceneNumber).chain(cameras.map(Cause::Camera)).collect();
    if budget.is_spent() { vec![] } else { causes }
}

/// Describes the causes. The first line names at most `MAX_CAUSES` causes, then counts the other
/// causes and names their files. If a right program draws the same picture with other options, the
/// first line also mentions these `options`. If the first cause is a listed mistake, further lines
/// describe that mistake.
fn describe_causes(causes: &[Cause], options: Option<&Options>) -> Vec<String> {
    let Some(first) = causes.first() else { return vec![] };
    let is_listed = causes.iter().all(|cause| matches!(cause, Cause::Mistake(_)));
    let start = match (is_listed, causes.len()) {
        (true, 1) => "A listed mistake gives",
        (true, _) => "Each of these listed mistakes gives",
        (false, 1) => "A change gives",
        (false, _) => "Each of these changes gives",
    };
    let mut list = join_first(causes.iter().map(Cause::to_string).collect(), MAX_CAUSES, "; ");
    let (named, more) = causes.split_at(causes.len().min(MAX_CAUSES));
    let mut files: Vec<_> = more.iter().filter_map(Cause::file).collect();
    files.sort_unstable();
    files.dedup();
    files.retain(|file| named.iter().all(|cause| cause.file() != Some(file)));
    if !files.is_empty() {
        list += &format!(", also in {}", files.join(", "));
    }
    let options_sentence =
        options.map(|options| format!(" {}", options.same_picture_sentence())).unwrap_or_default();
    let mut lines =
        vec![format!("{start} this very picture (others may, too): {list}.{options_sentence}")];
    if let Cause::Mistake(mistake) = first {
        lines.extend(diff_and_reason_of_mistake(mistake));
    }
    lines
}

/// Describes a listed mistake. Shows the diff unless it is too long. If the book shows the mistake,
/// also says why the code is wrong and which section to read.
fn diff_and_reason_of_mistake(mistake: &Mistake) -> Vec<String> {
    let diff = mistake.format_as_diff();
    let mut lines: Vec<_> = diff.lines().map(|line| format!("  {line}")).collect();
    if lines.len() > MAX_DIFF_LINES {
        lines.clear();
    }
    if let Some(presentation) = &mistake.presentation {
        lines.push(presentation.reason.to_owned());
    }
    lines.extend(section_sentence(mistake));
    lines
}

/// Returns the sentence that says which section of the book to read again, or None if the book
/// doesn't show the mistake.
pub(crate) fn section_sentence(mistake: &Mistake) -> Option<String> {
    let heading = mistake.presentation.as_ref()?.section;
    Some(format!("See step {}, \"{heading}\".", mistake.step.number()))
}

/// Describes how a picture of the right size differs from the target: the facts, the number of
/// wrong pixels, the `by_hand` tests to run, and one wrong pixel. Includes the tests of every step
/// that takes part in drawing the picture, since any of these steps may be wrong.
fn describe_wrong_pixels(comparison: &Comparison, facts: Vec<String>) -> Vec<String> {
    let Comparison { target, wrong, right, most_different } = comparison;
    let count = format!(
        "{} of {} pixels {} from {}, by up to {} of 255.",
        wrong.len(),
        wrong.len() + right.len(),
        if wrong.len() == 1 { "differs" } else { "differ" },
        target.title,
        most_different.largest_difference()
    );
    // If no byte is off by more than 1, the line with the count is more helpful than any fact.
    let (leading_facts, trailing_facts) =
        if most_different.largest_difference() == 1 { (vec![], facts) } else { (facts, vec![]) };
    let mut lines = [leading_facts, vec![count], trailing_facts].concat();
    if let Some(scene) = &target.scene {
        // Step 1 is never ruled out: even if the sky is right, the camera may be slightly off, or
        // rgb8 or Ray::at may be wrong.
        let steps = match scene.step {
            Step::Rays => "step 1".to_owned(),
            Step::Sphere => "steps 1 and 2".to_owned(),
            step => format!("steps 1 to {}", step.number()),
        };
        lines.push(format!("The tests by hand in {steps} may find it: {TEST_COMMAND}"));
    }
    lines.extend(describe_most_different_pixel(comparison).lines().map(str::to_owned));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use course::MistakePresentation;

    fn made_up_mistake(title: &'static str, file: &str) -> Mistake {
        Mistake {
            title,
            step: Step::Sphere,
            file: file.to_owned(),
            old: "a".to_owned(),
            new: "b".to_owned(),
            presentation: None,
        }
    }

    fn made_up_cause(title: &'static str, file: &str) -> Cause {
        Cause::Mistake(Box::leak(Box::new(made_up_mistake(title, file))))
    }

    #[test]
    fn files_of_all_causes_are_named_once() {
        let six_causes = [
            made_up_cause("slip 1", "a.rs"),
            made_up_cause("slip 2", "b.rs"),
            made_up_cause("slip 3", "a.rs"),
            made_up_cause("slip 4", "c.rs"),
            made_up_cause("slip 5", "b.rs"),
            made_up_cause("slip 6", "c.rs"),
        ];
        let number = Cause::SceneNumber("another number".to_owned());
        let two_causes = [six_causes[0].clone(), number];
        let cause_lists =
            [&six_causes[..], &six_causes[..1], &two_causes[1..], &two_causes[..], &[]];
        insta::assert_snapshot!(
            cause_lists.map(|causes| describe_causes(causes, None).join("\n")).join("\n\n")
        );
    }

    #[test]
    fn mistake_is_shown_with_its_diff_if_short_and_its_reason_if_any() {
        let short = made_up_mistake("slip", "a.rs");
        assert_eq!(diff_and_reason_of_mistake(&short), ["  - a", "  + b"]);
        let three_lines = Mistake { new: "b\nb\nb".to_owned(), ..short.clone() };
        assert_eq!(diff_and_reason_of_mistake(&three_lines), ["  - a", "  + b", "  + b", "  + b"]);
        let four_lines = "b\nb\nb\nb".to_owned();
        let presentation = MistakePresentation {
            pictures: vec![],
            reason: "It is b.",
            section: "Letters",
            effect: "",
        };
        let long = Mistake { new: four_lines, presentation: Some(presentation), ..short };
        assert_eq!(diff_and_reason_of_mistake(&long), ["It is b.", "See step 2, \"Letters\"."]);
    }
}
