use crate::answer::{Cause, join_first};
use crate::camera_fit::find_cameras;
use crate::changed_number::find_changed_numbers;
use crate::comparison::{Budget, Comparison};
use crate::facts::tell_facts;
use crate::listed_mistake::find_listed_mistakes;
use crate::other_options::{Options, find_options};
use crate::target::{Target, find_equal};
use crate::transformed::{describe_whole, uniform_colour};
use crate::wrong_pixel::describe_wrong_pixel;
use crate::{Answer, Verdict};
use course::Step;
use image::RgbImage;

const MOST_CAUSES: usize = 3;

/// Said of exercises, whose options can't be found.
const WITHOUT_OPTIONS: &str =
    "Ours is drawn without options: with some, a right program may draw another picture, too.\n";

const TESTS: &str = "cargo test --no-fail-fast --test by_hand";

/// How many rays may be computed to try changes.
const RAYS: u32 = 4_000_000;

/// Says what is known of a picture that isn't the one it should be.
pub(crate) fn explain(yours: &RgbImage, target: &Target) -> Answer {
    let title = &target.title;
    let listed = target.name.as_ref().map(|name| find_listed_mistakes(yours, name));
    let mut causes = listed.unwrap_or_default();
    let options = target.drawing.as_ref().and_then(|drawing| find_options(drawing, yours));
    // An angle that hardly anybody types comes after a listed mistake.
    if let Some(options) = &options
        && (options.is_plain_angle() || causes.is_empty())
    {
        return Answer::new(Verdict::OtherOptions, options.describe(title));
    }
    let comparison = Comparison::new(target, yours);
    let ((w, h), (columns, rows)) = (yours.dimensions(), target.picture.dimensions());
    let size = format!("Your picture is {w}×{h} pixels, and {title} {columns}×{rows}.\n");
    let mut whole = match find_equal(yours) {
        Some(name) => format!("This is the picture of {name}, not {title}.\n"),
        None => describe_whole(yours, &target.picture, title),
    };
    let is_unexplained = whole.is_empty();
    let is_other_size = comparison.is_none() && (is_unexplained || uniform_colour(yours).is_some());
    if is_other_size {
        whole.insert_str(0, &size);
    }
    if whole.is_empty() {
        causes.extend(comparison.iter().flat_map(find_changes));
    }
    let cause_lines = describe_causes(&causes, options.as_ref());
    let has_facts = whole.is_empty() && causes.is_empty();
    let facts = comparison.as_ref().filter(|_| has_facts).map(tell_facts).unwrap_or_default();
    let details = comparison.as_ref().map(|one| details(one, &facts)).unwrap_or_default();
    let is_exercise = target.drawing.is_none() && (is_unexplained || is_other_size);
    let note = if is_exercise { WITHOUT_OPTIONS } else { "" };
    // A cause helps most, then how the whole picture differs, then a fact. Whether it's only by 1
    // of 255 is in the first of the details.
    let is_by_1 = comparison.as_ref().is_some_and(|one| one.farthest.largest_difference() == 1);
    let fact_lines = if is_by_1 { String::new() } else { facts.join("\n") };
    let parts = [&cause_lines, &whole, &fact_lines, &details];
    let feedback = parts.iter().find_map(|part| part.lines().next()).unwrap_or_default();
    let feedback = feedback.to_owned();
    let text = format!("Not right. {whole}{cause_lines}{details}{note}").trim_end().to_owned();
    let compared = comparison.map(|_| [yours.clone(), target.picture.clone()]);
    Answer { causes, compared, feedback, ..Answer::new(Verdict::NotRight, text) }
}

/// All numbers and cameras that we know and that give the whole picture; none where not all
/// could be tried.
fn find_changes(comparison: &Comparison) -> Vec<Cause> {
    let Some(drawing) = &comparison.target.drawing else { return vec![] };
    let budget = Budget::new(RAYS);
    let causes = |all: Vec<String>, step| {
        let causes = all.into_iter();
        causes.map(move |words| Cause { words, step, file: None, details: String::new() })
    };
    let numbers = causes(find_changed_numbers(comparison, drawing, &budget), None);
    let cameras = causes(find_cameras(comparison, drawing, &budget), Some(Step::Rays));
    let all = numbers.chain(cameras).collect();
    if budget.is_spent() { vec![] } else { all }
}

/// Lines about causes: as many as there is room for, the files of all, and the first in full. Options
/// with which a right program draws the picture are as good an explanation.
fn describe_causes(causes: &[Cause], options: Option<&Options>) -> String {
    let Some(first) = causes.first() else { return String::new() };
    let is_listed = causes.iter().all(|cause| cause.file.is_some());
    let start = match (is_listed, causes.len()) {
        (true, 1) => "A listed mistake gives",
        (true, _) => "Each of these listed mistakes gives",
        (false, 1) => "A change gives",
        (false, _) => "Each of these changes gives",
    };
    let words = causes.iter().map(Cause::words_and_file).collect();
    let mut words = join_first(words, MOST_CAUSES, "; ");
    let (told, more) = causes.split_at(causes.len().min(MOST_CAUSES));
    let mut files: Vec<_> = more.iter().filter_map(|cause| cause.file.as_deref()).collect();
    files.sort_unstable();
    files.dedup();
    files.retain(|file| told.iter().all(|cause| cause.file.as_deref() != Some(file)));
    if !files.is_empty() {
        words += &format!(", also in {}", files.join(", "));
    }
    let details = &first.details;
    let options = options.map(|options| format!(" {}", options.same_picture_sentence()));
    let options = options.unwrap_or_default();
    format!("{start} this very picture, as others may: {words}.{options}\n{details}")
}

/// Lines on a picture of the right size: how many pixels differ; the facts, if nothing explains it;
/// the tests by hand of the steps that draw it, any of which may be wrong; one pixel.
fn details(comparison: &Comparison, facts: &[String]) -> String {
    let Comparison { target, wrong, right, farthest } = comparison;
    let mut text = format!(
        "{} of {} pixels {} from {}, by up to {} of 255.\n",
        wrong.len(),
        wrong.len() + right.len(),
        if wrong.len() == 1 { "differs" } else { "differ" },
        target.title,
        farthest.largest_difference()
    );
    text.extend(facts.iter().flat_map(|fact| [fact, "\n"]));
    if let Some(drawing) = &target.drawing {
        // Even where the sky is right, the camera may be off by a little, and rgb8 or Ray::at wrong.
        let steps = match drawing.step {
            Step::Rays => "step 1".to_owned(),
            Step::Sphere => "steps 1 and 2".to_owned(),
            step => format!("steps 1 to {}", step.number()),
        };
        text += &format!("The tests by hand of {steps} may find it: {TESTS}\n");
    }
    text + &describe_wrong_pixel(comparison)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_all_causes_are_named_once() {
        let cause = |words: &str, file: Option<&str>| Cause {
            words: words.to_owned(),
            step: None,
            file: file.map(str::to_owned),
            details: format!("Details of {words}.\n"),
        };
        let listed = ["a.rs", "b.rs", "a.rs", "c.rs", "b.rs", "c.rs"].into_iter().zip(1..);
        let listed = listed.map(|(file, number)| cause(&format!("slip {number}"), Some(file)));
        let listed: Vec<_> = listed.collect();
        let number = cause("another number", None);
        let both = [listed[0].clone(), number];
        let all = [&listed[..], &listed[..1], &both[1..], &both[..], &[]];
        insta::assert_snapshot!(all.map(|causes| describe_causes(causes, None)).join("\n"));
    }
}
