use crate::changed_number::find_changes;
use crate::check::equal_name;
use crate::comparison::Comparison;
use crate::drawing::bytes;
use crate::facts::tell_facts;
use crate::listed_mistake::tell_listed_mistakes;
use crate::other_options::describe_other_options;
use crate::scene_facts::describe_regions;
use crate::scene_mistake::scene_mistakes;
use crate::target::Target;
use crate::transformed::{cut_or_enlarged_clause, turned_or_swapped_clauses, uniform_colour};
use crate::wrong_pixel::{count_sentence, describe_wrong_pixel};
use crate::{Answer, Cause, LockedPictures, Picture, Verdict};
use course::{Mistake, Step, draw_panels, find_mistakes_with_hash, hash_picture, step_of_example};

/// The most changes that are told.
const MOST_CHANGES: usize = 3;

/// Says what is known of a picture that isn't the one it should be.
pub(crate) fn explain(picture: &Picture, target: &Target, locked: &LockedPictures) -> Answer {
    let (yours, ours) = (&picture.rows, &*target.picture);
    let varied = target.drawing.as_ref().filter(|_| uniform_colour(yours).is_none());
    let options = varied.and_then(|one| describe_other_options(one, &target.title, picture));
    if let Some(text) = options {
        return Answer::new(Verdict::RightWithOtherOptions, text);
    }
    let comparison = (picture.size == ours.dimensions()).then(|| Comparison::new(target, yours));
    let other = equal_name(picture, locked);
    let other = other.map(|name| format!("This is the picture of {name}, not {}.\n", target.title));
    let whole = if other.is_none() { whole_picture_statement(picture, target) } else { None };
    let (listed, drawn_for) = listed_mistakes(picture, target, comparison.as_ref());
    let (listed, cause) = tell_listed_mistakes(&listed, drawn_for.as_deref()).unzip();
    let changes = match &comparison {
        Some(comparison) if other.is_none() && whole.is_none() => find_changes(comparison),
        _ => vec![],
    };
    let mut cause: Cause = cause.unwrap_or_default();
    if let ([change], None) = (&changes[..], &listed) {
        cause.mistake = Some(change.clone());
    }
    let known = [whole, listed, changes_statement(&changes, target)].into_iter().flatten();
    let known: String = known.collect();
    let details = match &comparison {
        Some(comparison) => details(comparison, target, cause.step, known.is_empty()),
        None if known.is_empty() => size_lines(picture, target),
        None => String::new(),
    };
    let text = format!("Not right. {}{known}{details}", other.unwrap_or_default());
    let difference = comparison.map(|_| draw_panels(yours, ours));
    Answer { verdict: Verdict::NotRight, text: text.trim_end().to_owned(), cause, difference }
}

/// A statement on a picture of one colour, or on one that is ours turned, cut or enlarged.
fn whole_picture_statement(picture: &Picture, target: &Target) -> Option<String> {
    let (yours, ours) = (&picture.rows, &*target.picture);
    if let Some([r, g, b]) = uniform_colour(yours).filter(|_| picture.row_step == 1) {
        return Some(format!("Your picture is one colour, ({r}, {g}, {b}), in all pixels.\n"));
    }
    let clauses = match picture.row_step {
        1 => turned_or_swapped_clauses(yours, ours).join(", or "),
        _ => String::new(),
    };
    let clause = Some(clauses).filter(|clauses| !clauses.is_empty());
    let clause = clause.or_else(|| cut_or_enlarged_clause(picture, ours))?;
    Some(format!("This is {}, {clause}.\n", target.title))
}

/// The listed mistakes that give a picture, and the name of the locked picture that they were
/// drawn for where it isn't the target.
fn listed_mistakes(
    picture: &Picture,
    target: &Target,
    comparison: Option<&Comparison>,
) -> (Vec<Mistake>, Option<String>) {
    if let Some(expected) = &target.name {
        let mut all = find_mistakes_with_hash(hash_picture(&picture.rows));
        if all.iter().any(|(_, name)| name == expected) {
            all.retain(|(_, name)| name == expected);
        }
        let drawn_for = all.first().map(|(_, name)| name.clone()).filter(|name| name != expected);
        return (all.into_iter().map(|(mistake, _)| mistake).collect(), drawn_for);
    }
    let Some((comparison, drawing)) = comparison.zip(target.drawing.as_ref()) else {
        return (vec![], None);
    };
    let all = scene_mistakes().into_iter().filter(|(_, formulas)| {
        comparison.pixels.iter().all(|pixel| {
            bytes(formulas.colour(&drawing.scene, &comparison.ray(pixel))) == pixel.yours
        })
    });
    (all.map(|(mistake, _)| mistake).collect(), None)
}

/// A statement on the changes of ours that give the whole picture.
fn changes_statement(changes: &[String], target: &Target) -> Option<String> {
    if changes.is_empty() {
        return None;
    }
    let more = match changes.len().saturating_sub(MOST_CHANGES) {
        0 => String::new(),
        more => format!(", or with one of {more} other numbers"),
    };
    let told = changes[..changes.len().min(MOST_CHANGES)].join(", or ");
    Some(format!("It is, in every pixel, {} {told}{more}.\n", target.title))
}

/// Lines on a picture of the right size: how many pixels differ; the facts and the regions, if
/// nothing explains it; the tests by hand, those of one step where that is known; one pixel.
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
            // The sky and bytes are step 1's.
            let is_of_rays =
                wrong.iter().any(|one| one.is_sky()) || wrong.iter().all(|one| one.is_above_1);
            let first = if is_of_rays { Step::Rays } else { Step::Sphere };
            let [first, last] = step.map_or([first, drawing.step], |step| [step; 2]);
            text += &tests_line(first, last);
        }
        None => text += &check_step_first_line(target),
    }
    text + &describe_wrong_pixel(comparison)
}

/// Lines on a picture of another size that nothing explains.
fn size_lines(picture: &Picture, target: &Target) -> String {
    let ((w, h), (columns, rows), title) =
        (picture.size, target.picture.dimensions(), &target.title);
    format!(
        "Your picture is {w}×{h} pixels, and {title} {columns}×{rows}.\n\
         Draw it with the default options for a more detailed diagnosis.\n"
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
