use crate::answer::{Cause, common_part, join_first};
use crate::camera_fit::find_cameras;
use crate::changed_number::find_changed_numbers;
use crate::comparison::{Budget, Comparison};
use crate::facts::{are_above_1, tell_facts};
use crate::listed_mistake::find_listed_mistakes;
use crate::other_options::describe_other_options;
use crate::target::{Target, find_equal};
use crate::transformed::{describe_whole, uniform_colour};
use crate::wrong_pixel::describe_wrong_pixel;
use crate::{Answer, Verdict};
use course::Step;
use image::RgbImage;

const MOST_CAUSES: usize = 3;

const TESTS: &str = "cargo test --no-fail-fast --test by_hand";

/// How many rays may be computed to try changes.
const RAYS: u32 = 4_000_000;

/// Says what is known of a picture that isn't the one it should be.
pub(crate) fn explain(yours: &RgbImage, target: &Target) -> Answer {
    let title = &target.title;
    let varied = target.drawing.as_ref().filter(|_| uniform_colour(yours).is_none());
    if let Some(text) = varied.and_then(|one| describe_other_options(one, title, yours)) {
        let causes = find_listed_mistakes(yours, target);
        let text = format!("{text}\n{}", tell_causes(&causes)).trim_end().to_owned();
        return Answer { causes, ..Answer::new(Verdict::OtherOptions, text) };
    }
    let comparison = Comparison::new(target, yours);
    let whole = match find_equal(yours) {
        Some(name) => format!("This is the picture of {name}, not {title}.\n"),
        None => describe_whole(yours, &target.picture, title),
    };
    let mut causes = find_listed_mistakes(yours, target);
    if whole.is_empty() {
        causes.extend(comparison.iter().flat_map(find_changes));
    }
    let is_explained = !whole.is_empty() || !causes.is_empty();
    let facts = comparison.as_ref().filter(|_| !is_explained).map(tell_facts).unwrap_or_default();
    let details = match &comparison {
        Some(comparison) => details(comparison, &causes, &facts),
        None if !is_explained => {
            let ((w, h), (columns, rows)) = (yours.dimensions(), target.picture.dimensions());
            format!("Your picture is {w}×{h} pixels, and {title} {columns}×{rows}.")
        }
        None => String::new(),
    };
    let cause_lines = tell_causes(&causes);
    // A cause helps most, then how the whole picture differs, then a fact. Whether it's only by 1
    // of 255 is in the first of the details.
    let is_by_1 = comparison.as_ref().is_some_and(|one| one.farthest.largest_difference() == 1);
    let fact_lines = if is_by_1 { String::new() } else { facts.join("\n") };
    let parts = [&cause_lines, &whole, &fact_lines, &details];
    let feedback = parts.iter().find_map(|part| part.lines().next()).unwrap_or_default();
    let feedback = feedback.to_owned();
    let text = format!("Not right. {whole}{cause_lines}{details}").trim_end().to_owned();
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

/// Lines about causes: all of them as far as there is room, and the first in full.
fn tell_causes(causes: &[Cause]) -> String {
    let Some(first) = causes.first() else { return String::new() };
    let start = if causes.len() == 1 { "This" } else { "Each of these" };
    let told = join_first(causes.iter().map(Cause::words_and_file).collect(), MOST_CAUSES, "; ");
    let details = &first.details;
    format!("{start} gives the picture, in every pixel: {told}.\n{details}")
}

/// Lines on a picture of the right size: how many pixels differ; the facts, if nothing explains it;
/// the tests by hand, from the first step that may be wrong; one pixel.
fn details(comparison: &Comparison, causes: &[Cause], facts: &[String]) -> String {
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
        // The sky and bytes are step 1's.
        let is_of_rays = wrong.iter().any(|one| one.hit.is_none()) || are_above_1(wrong, drawing);
        let first = if is_of_rays { Step::Rays } else { Step::Sphere };
        let number = common_part(causes, |cause| cause.step).unwrap_or(first).number();
        text += &format!("From step {number} on, the tests by hand may find it: {TESTS}\n");
    }
    text + &describe_wrong_pixel(comparison)
}
