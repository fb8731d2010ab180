use crate::byte_encodings::encoding_candidates;
use crate::disturbed::{lossy_candidate, rounding_candidate, shifted_ray_candidates};
use crate::evidence::{Evidence, Pixel};
use crate::explanation::{Explanation, RayBudget, find_first_that_holds};
use crate::listed_mistake::explain_listed_mistake;
use crate::missing_parts::{missing_object_candidates, term_candidates};
use crate::other_options::describe_other_options;
use crate::pixel_regions::computed_values_clause;
use crate::scene_parameter::changed_number_candidates;
use crate::sky::{camera_candidate, sky_colour_candidates};
use crate::source_ref::{find_source_ref, go_back_sentences, test_command_sentence};
use crate::transformed::{crop_or_scale_clause, turned_or_swapped_clause};
use crate::wrong_regions::describe_wrong_regions;
use crate::{Locked, escape_for_terminal, png_file, which_picture};
use course::draw_panels;
use course::{Step, camera_with_size, find_mistakes_with_hash, hash_picture};
use image::RgbImage;

/// How many rays may be computed to try explanations.
const RAYS: u32 = 4_000_000;

/// Text and exit code of an answer of `check`.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// 0 if the picture is right, 1 if it is not, 2 if there is nothing to compare.
    pub code: u8,
    /// At most a dozen lines, of which the first says the most.
    pub text: String,
    /// The reader's picture, ours and the difference side by side, where they differ and
    /// have one size.
    pub difference: Option<RgbImage>,
}

impl Answer {
    /// An answer of words alone.
    pub fn new(code: u8, text: String) -> Self {
        Self { code, text, difference: None }
    }
}

/// Compares the picture in a PNG file with the locked picture `name`; where that is
/// left out, with the one that the file's own name tells, or else with the nearest.
///
/// Reads nothing but what it is given: no file, no argument, no time.
pub fn check_png(
    png: &[u8],
    file_name: &str,
    expected_name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    let picture = match png_file::read_png(png) {
        Ok(picture) => picture,
        Err(what) => {
            let file_name = escape_for_terminal(file_name);
            return Answer::new(2, format!("error: {file_name} {what}"));
        }
    };
    let names = locked.iter().map(|one| one.name.as_str());
    let expected_name =
        expected_name.or_else(|| which_picture::find_name_in_file_name(file_name, names));
    let mut answer = check_picture(&picture.pixels, expected_name, locked);
    if answer.code < 2 && picture.is_invisible {
        answer.text = format!(
            "Not right: alpha is 0 in every pixel, so that a viewer shows nothing. Of the \
             colours alone this can be said:\n{}",
            answer.text
        );
        answer.code = 1;
    }
    if answer.code < 2 {
        for note in picture.notes {
            answer.text += &format!("\n{note}");
        }
    }
    answer
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn check_picture(yours: &RgbImage, expected_name: Option<&str>, locked: &[Locked]) -> Answer {
    let is_asked = |one: &&Locked| expected_name.is_none_or(|expected| expected == one.name);
    let candidates: Vec<_> = locked.iter().filter(is_asked).collect();
    if candidates.is_empty() {
        let names: Vec<_> = locked.iter().map(|one| one.name.as_str()).collect();
        let text = format!(
            "error: there is no locked picture '{}'; allowed are {}",
            escape_for_terminal(expected_name.unwrap_or_default()),
            names.join(", ")
        );
        return Answer::new(2, text);
    }
    if let Some(right) = candidates.iter().find(|one| one.picture == *yours) {
        let name = &right.name;
        let text = format!("Right: this is the picture of {name}, in every pixel.");
        return Answer::new(0, text);
    }
    let ours = which_picture::find_most_similar(yours, &candidates);
    let step = Step::from_name(&ours.name);
    let varied = step.filter(|_| uniform_colour(yours).is_none());
    if let Some(text) = varied.and_then(|step| describe_other_options(step, yours)) {
        return Answer::new(1, text);
    }
    let text = match locked.iter().find(|one| one.picture == *yours) {
        Some(other) => explain_other_picture(yours, ours, other),
        None => explain_wrong_picture(yours, ours),
    };
    let is_size = yours.dimensions() == ours.picture.dimensions();
    let difference = is_size.then(|| draw_panels(yours, &ours.picture));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
}

/// Lines about a picture that is the right one of another name.
fn explain_other_picture(yours: &RgbImage, ours: &Locked, other: &Locked) -> String {
    let (name, expected_name) = (&other.name, &ours.name);
    let start = format!("Not right: this is the picture of {name}, not of {expected_name}.");
    let steps = [name, expected_name].map(|name| Step::from_name(name));
    let [Some(found_step), Some(expected_step)] = steps else {
        return format!("{start}\n{}", hint_to_check_step_first(expected_name));
    };
    let missing = match (found_step, expected_step) {
        _ if expected_step < found_step => return start,
        (Step::Diffuse, _) => "The highlights are missing",
        (Step::Nearest, _) => "The light is missing: each object has one colour",
        (Step::Rays, _) => "The objects are missing: no ray meets one",
        _ => "The nine objects are missing",
    };
    let later = Step::ALL.into_iter().filter(|step| found_step < *step && *step <= expected_step);
    let later: Vec<_> = later.collect();
    let is_listed =
        find_mistakes_with_hash(hash_picture(yours)).iter().any(|(_, name)| name == expected_name);
    let mistake_text = explain_listed_mistake(yours, expected_name).filter(|_| is_listed);
    let tests = mistake_text.unwrap_or_else(|| test_command_sentence(&later));
    format!("{start}\n{missing}. (Or the file is that of step {}.)\n{tests}", found_step.number())
}

/// Tells which step's picture to check first, where that of an exercise is wrong.
fn hint_to_check_step_first(exercise_name: &str) -> String {
    let Some(step) = course::step_of_example(exercise_name) else {
        return String::new();
    };
    let step_name = step.name();
    format!(
        "First ask about step {}'s picture, from which this one is made: cargo run --bin \
         check -- {step_name}.png\n",
        step.number()
    )
}

/// Lines about what went wrong.
fn explain_wrong_picture(yours: &RgbImage, ours: &Locked) -> String {
    let Locked { name, picture } = ours;
    let step = Step::from_name(name);
    let (size @ (w, h), our_size) = (yours.dimensions(), picture.dimensions());
    let mistake_text = explain_listed_mistake(yours, name);
    if let Some(clause) = few_colours_clause(yours, picture) {
        let steps = Step::ALL.into_iter().filter(|one| Some(*one) <= step);
        let tests = || match step {
            Some(_) => test_command_sentence(&steps.collect::<Vec<_>>()),
            None => hint_to_check_step_first(name),
        };
        let tests = mistake_text.unwrap_or_else(tests);
        return format!("Not right: your picture is {clause}.\n{tests}");
    }
    if let Some((clause, file)) = turned_or_swapped_clause(yours, picture) {
        let back = mistake_text.unwrap_or_else(|| go_back_to_files(&[file]));
        return format!("Not right: your picture is that of {name}{clause}.\n{back}");
    }
    if size != our_size {
        let (columns, rows) = our_size;
        let step = step.filter(|_| 2 <= w && w * h <= 9 * columns * rows);
        let drawn = step.map(|step| (step.picture())(&camera_with_size(w, h), 1));
        if let Some(clause) = crop_or_scale_clause(yours, picture, drawn.as_ref()) {
            return format!("Not right: your picture is that of {name}{clause}.");
        }
        return format!(
            "Not right yet, compared with {name}.\nIt is {w}×{h} pixels, and ours \
             {columns}×{rows}: draw it with the default options, and more can be told.\n"
        );
    }
    let evidence = Evidence::new(step, yours, picture);
    let others = mistake_text.is_none().then(|| candidates(&evidence));
    let candidates = encoding_candidates(&evidence).chain(others.into_iter().flatten());
    let budget = RayBudget::new(RAYS);
    let found = find_first_that_holds(&evidence, candidates, &budget);
    let text = match (found, mistake_text) {
        (Some(Explanation { sentence, files, .. }), mistake_text) => format!(
            "Not right: {}\n{}",
            lowercase_first_letter(&sentence),
            mistake_text.unwrap_or_else(|| go_back_to_files(&files))
        ),
        (None, Some(text)) => {
            format!("Not right: {}", lowercase_first_letter(&text))
        }
        (None, None) => format!(
            "Not right yet, compared with {name}.\n{}",
            match step {
                Some(step) => describe_wrong_regions(&evidence, step),
                None => hint_to_check_step_first(name),
            }
        ),
    };
    text + &sentences_of_wrong_pixel(&evidence)
}

/// The explanations of a picture that is no mistake of the list, the strongest first.
fn candidates(evidence: &Evidence) -> impl Iterator<Item = Explanation<'_>> {
    missing_object_candidates(evidence)
        .chain(changed_number_candidates(evidence))
        .chain(term_candidates(evidence))
        .chain(shifted_ray_candidates(evidence))
        .chain(camera_candidate(evidence))
        .chain(sky_colour_candidates(evidence))
        .chain(rounding_candidate(evidence))
        .chain(lossy_candidate(evidence))
}

/// The colour of all pixels, where it is one.
fn uniform_colour(picture: &RgbImage) -> Option<[u8; 3]> {
    let first = picture.get_pixel_checked(0, 0)?;
    picture.pixels().all(|pixel| pixel == first).then_some(first.0)
}

/// Half a sentence about a picture of one colour, or of grey alone where ours is not.
fn few_colours_clause(yours: &RgbImage, ours: &RgbImage) -> Option<String> {
    if let Some([r, g, b]) = uniform_colour(yours) {
        return Some(format!("one colour, ({r}, {g}, {b}), in all pixels"));
    }
    let is_grey = |picture: &RgbImage| picture.pixels().all(|one| one.0 == [one[0]; 3]);
    let is_told = is_grey(yours) && !is_grey(ours);
    is_told.then(|| "grey in every pixel, and ours is not".to_owned())
}

/// Tells where to go back to, by names such as `step01_rays/rgb8.rs`.
fn go_back_to_files(files: &[&str]) -> String {
    let places = files.iter().filter_map(|file| find_source_ref(file));
    go_back_sentences(&places.collect::<Vec<_>>())
}

/// A sentence as it goes on after a colon.
fn lowercase_first_letter(sentence: &str) -> String {
    let mut letters = sentence.chars();
    let first = letters.next().map(|c| c.to_lowercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// One pixel that is wrong, among those that differ most, and how many there are.
fn sentences_of_wrong_pixel(evidence: &Evidence) -> String {
    let wrong = evidence.wrong_pixels();
    let Some(most) = wrong.iter().map(Pixel::largest_channel_difference).max() else {
        return String::new();
    };
    let mut most_different: Vec<_> = wrong
        .iter()
        .filter(|pixel| most.div_ceil(2) <= pixel.largest_channel_difference())
        .collect();
    most_different.sort_by_key(|pixel| (pixel.j, pixel.i));
    let pixel = most_different[most_different.len() / 2];
    let computed = evidence.step.map_or(String::new(), |step| {
        format!(": {}", computed_values_clause(step, &evidence.our_ray(pixel)))
    });
    let [a, b] = [pixel.yours, pixel.ours].map(|[r, g, b]| format!("({r}, {g}, {b})"));
    format!(
        "{} of {} pixels differ, by up to {most} of 255.\n\
         Column {}, row {}: yours is {a}, ours {b}{computed}.\n",
        wrong.len(),
        evidence.pixels.len(),
        pixel.i,
        pixel.j,
    )
}
