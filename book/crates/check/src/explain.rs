use crate::camera_fit::find_cameras;
use crate::changed_number::find_changed_numbers;
use crate::check::equal_name;
use crate::comparison::{Comparison, Pixel, RayBudget};
use crate::facts::tell_facts;
use crate::listed_mistake::{find_listed_mistakes, tell_listed_mistakes};
use crate::other_options::describe_other_options;
use crate::regions::describe_regions;
use crate::target::Target;
use crate::transformed::{describe_whole, uniform_colour};
use crate::wrong_pixel::{count_sentence, describe_wrong_pixel};
use crate::{Answer, Cause, LockedPictures, Verdict};
use course::{Step, step_of_example};
use image::RgbImage;

/// The most changes that are told.
const MOST_CHANGES: usize = 3;

/// How many rays may be computed to try changes.
const RAYS: u32 = 4_000_000;

/// Says what is known of a picture that isn't the one it should be.
pub(crate) fn explain(yours: &RgbImage, target: &Target, locked: &LockedPictures) -> Answer {
    let title = &target.title;
    let varied = target.drawing.as_ref().filter(|_| uniform_colour(yours).is_none());
    if let Some(text) = varied.and_then(|one| describe_other_options(one, title, yours)) {
        return Answer::new(Verdict::RightWithOtherOptions, text);
    }
    let comparison = Comparison::new(target, yours);
    let mut explanation = match equal_name(yours, locked) {
        Some(name) => format!("This is the picture of {name}, not {title}.\n"),
        None => describe_whole(yours, &target.picture, title),
    };
    let (numbers, cameras) = match &comparison {
        Some(comparison) if explanation.is_empty() => find_changes(comparison),
        _ => (vec![], vec![]),
    };
    let (mistakes, drawn_for) = find_listed_mistakes(yours, target, comparison.as_ref());
    let text_and_cause = tell_listed_mistakes(&mistakes, drawn_for);
    let has_listed = text_and_cause.is_some();
    let (text, mut cause) = text_and_cause.unwrap_or_default();
    explanation += &text;
    if has_listed && !numbers.is_empty() {
        cause = Cause { all: cause.all, ..Cause::default() };
    }
    let changes = [numbers, cameras].concat();
    cause.all.extend(changes.iter().cloned());
    if let ([change], false) = (&changes[..], has_listed) {
        cause.mistake = Some(change.clone());
    }
    if !changes.is_empty() {
        explanation += &format!("It is, in every pixel, {title} {}.\n", join_changes(&changes));
    }
    let details = match &comparison {
        Some(comparison) => details(comparison, target, cause.step, explanation.is_empty()),
        None if explanation.is_empty() => size_lines(yours, target),
        None => String::new(),
    };
    let text = format!("Not right. {explanation}{details}").trim_end().to_owned();
    let compared = comparison.map(|_| [yours.clone(), RgbImage::clone(&target.picture)]);
    Answer { verdict: Verdict::NotRight, text, cause, compared }
}

/// All numbers and cameras that we know and that give the whole picture, in words; none where
/// not all could be tried.
fn find_changes(comparison: &Comparison) -> (Vec<String>, Vec<String>) {
    let Some(drawing) = comparison.drawing else { return (vec![], vec![]) };
    let budget = RayBudget::new(RAYS);
    let numbers = find_changed_numbers(comparison, drawing, &budget);
    let cameras = find_cameras(comparison, drawing, &budget);
    if budget.is_spent() { (vec![], vec![]) } else { (numbers, cameras) }
}

/// The first changes, and how many more there are.
fn join_changes(changes: &[String]) -> String {
    let first = changes[..changes.len().min(MOST_CHANGES)].join(", or ");
    match changes.len().saturating_sub(MOST_CHANGES) {
        0 => first,
        more => format!("{first}, or with one of {more} other numbers"),
    }
}

/// Lines on a picture of the right size: how many pixels differ; the facts and the regions, if
/// nothing explains it; the tests by hand, from the first step that may be wrong; one pixel.
fn details(
    comparison: &Comparison,
    target: &Target,
    step: Option<Step>,
    has_facts: bool,
) -> String {
    let mut text = count_sentence(comparison, &target.title);
    if has_facts {
        text.extend(tell_facts(comparison).into_iter().map(|fact| fact + "\n"));
    }
    match &target.drawing {
        Some(drawing) => {
            if has_facts {
                text += &describe_regions(comparison, drawing);
            }
            let wrong = comparison.wrong_pixels();
            let is_above_1 = |one: &Pixel| 1.0 < drawing.colour(&one.ray).max_element();
            // The sky and bytes are step 1's.
            let is_of_rays = wrong.iter().any(Pixel::is_sky) || wrong.iter().all(is_above_1);
            let first = if is_of_rays { Step::Rays } else { Step::Sphere };
            text += &tests_line(step.unwrap_or(first), drawing.step);
        }
        None => text += &check_step_first_line(target),
    }
    text + &describe_wrong_pixel(comparison)
}

/// Lines on a picture of another size that nothing explains.
fn size_lines(yours: &RgbImage, target: &Target) -> String {
    let ((w, h), (columns, rows)) = (yours.dimensions(), target.picture.dimensions());
    format!(
        "Your picture is {w}×{h} pixels, and {} {columns}×{rows}.\n\
         Draw it with the default options for a more detailed diagnosis.\n",
        target.title
    )
}

/// The tests by hand of some steps.
fn tests_line(first: Step, last: Step) -> String {
    let (package, steps) = match (first.number(), last.number()) {
        (a, b) if a == b => (format!(" -p {}", first.name()), format!("step {a}")),
        (a, b) if a + 1 == b => (" --no-fail-fast".into(), format!("steps {a} and {b}")),
        (a, b) => (" --no-fail-fast".into(), format!("steps {a} to {b}")),
    };
    format!("The tests by hand of {steps} may find it: cargo test{package} --test by_hand\n")
}

/// Which step's picture to check first, where that of an exercise is wrong.
fn check_step_first_line(target: &Target) -> String {
    let step = target.name.as_deref().and_then(step_of_example);
    step.map_or(String::new(), |step| {
        let (number, name) = (step.number(), step.name());
        format!("First check step {number}'s picture: cargo run --bin check -- {name}.png\n")
    })
}
