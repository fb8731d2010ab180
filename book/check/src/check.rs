use crate::byte_curve::{
    byte_table_candidate, encode_candidates, factor_and_power_candidates,
    find_other_encode_of_sky,
};
use crate::camera_from_sky::{camera_candidate, sky_colour_candidates};
use crate::crop_or_scale::crop_or_scale_clause;
use crate::disturbed::{
    lossy_candidate, random_ray_candidate, recoloured_candidate,
    rounding_candidate, shifted_ray_candidates,
};
use crate::evidence::{Evidence, Pixel};
use crate::explanation::{Explanation, RayBudget, find_first_that_holds};
use crate::listed_mistake::explain_listed_mistake;
use crate::missing_parts::{
    missing_or_doubled_term_candidates, object_candidates, scaled_term_candidates,
    undrawn_pixels_candidate,
};
use crate::other_options::{draw_rows, find_other_options};
use crate::pixel_regions::computed_values_clause;
use crate::scene_parameter::changed_number_candidates;
use crate::source_ref::{
    find_source_ref, go_back_sentences, test_command_sentence,
};
use crate::step_scene::{ENCODE, intensity_function, scene_of_step};
use crate::transformed::{
    OurPicture, has_our_colours_elsewhere, rearranged_candidates, turned_candidates,
};
use crate::wrong_regions::describe_wrong_regions;
use crate::{
    Answer, Locked, Picture, Step, default_camera, escape_for_terminal,
    find_mistakes_with_hash, hash_picture, png_file, which_picture,
};
use compare::{Difference, draw_panels};
use image::{Rgb, RgbImage};
use std::rc::Rc;

/// The most pixels in which explanations are asked: those of a locked picture.
const COMPARED: u32 = 640 * 360;

/// How many rays may be computed for an answer.
const RAYS: u32 = 4_000_000;

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
    match png_file::read_png(png) {
        Ok(picture) => {
            let names = locked.iter().map(|one| one.name.as_str());
            let expected_name = expected_name.or_else(|| {
                which_picture::find_name_in_file_name(file_name, names)
            });
            let mut answer = check_read_picture(&picture, expected_name, locked);
            if answer.code < 2 && picture.is_invisible {
                answer.text = format!(
                    "Not right: alpha is 0 in every pixel, so that a viewer shows nothing. \
                     Of the colours alone this can be said:\n{}",
                    answer.text
                );
                answer.code = 1;
            }
            if answer.code < 2 && !picture.notes.is_empty() {
                answer.text =
                    format!("{}\n{}", answer.text, picture.notes.join("\n"));
            }
            answer
        }
        Err(what) => Answer::new(
            2,
            format!("error: {} {what}", escape_for_terminal(file_name)),
        ),
    }
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn check_picture(
    yours: &RgbImage,
    expected_name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    check_read_picture(
        &Picture::from_all_rows(yours.clone()),
        expected_name,
        locked,
    )
}

fn check_read_picture(
    yours: &Picture,
    expected_name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    let is_asked = |one: &&Locked| {
        expected_name.is_none_or(|expected_name| expected_name == one.name)
    };
    let candidates: Vec<_> = locked.iter().filter(is_asked).collect();
    if candidates.is_empty() {
        let names: Vec<_> = locked.iter().map(|one| one.name.as_str()).collect();
        let (expected_name, names) = (
            escape_for_terminal(expected_name.unwrap_or_default()),
            names.join(", "),
        );
        let text = format!(
            "error: there is no locked picture '{expected_name}'; allowed are {names}"
        );
        return Answer::new(2, text);
    }
    let is_this =
        |one: &&&Locked| yours.has_all_rows() && one.picture == yours.pixels;
    let right = candidates.iter().find(is_this);
    let ours = right.copied().unwrap_or_else(|| {
        which_picture::find_most_similar(&yours.pixels, &candidates)
    });
    if right.is_some() {
        let expected_name = &ours.name;
        let text = format!(
            "Right: this is the picture of {expected_name}, in every pixel."
        );
        return Answer::new(0, text);
    }
    let budget = RayBudget::new(RAYS);
    let step = Step::from_name(&ours.name).filter(|_| 2 <= yours.size.0);
    if let Some((step, options)) = step
        .and_then(|step| Some((step, find_other_options(step, yours, &budget)?)))
    {
        let is_right = options.are_default_but_size() && !yours.has_all_rows();
        return Answer::new(u8::from(!is_right), options.sentences(step, yours));
    }
    let is_size = yours.size == ours.picture.dimensions();
    let ours_at_size = match step.filter(|_| yours.has_all_rows()) {
        _ if is_size => Some(ours.picture.clone()),
        Some(step) => {
            Some(step.draw_picture(&default_camera(yours.size.0, yours.size.1), 1))
        }
        None => None,
    };
    let other_name_match = locked.iter().find(|one| is_this(&one));
    let text = match other_name_match {
        Some(other) => explain_other_picture(&yours.pixels, ours, other),
        None => {
            explain_wrong_picture(yours, ours, ours_at_size.as_ref(), step, &budget)
        }
    };
    let difference =
        ours_at_size.map(|ours_at_size| draw_panels(&yours.pixels, &ours_at_size));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
}

/// Lines about a picture that is the right one of another name.
fn explain_other_picture(
    yours: &RgbImage,
    ours: &Locked,
    other: &Locked,
) -> String {
    let (name, expected_name) = (&other.name, &ours.name);
    let start = format!(
        "Not right: this is the picture of {name}, not of {expected_name}."
    );
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
    let later = Step::ALL
        .into_iter()
        .filter(|step| found_step < *step && *step <= expected_step);
    let later: Vec<_> = later.collect();
    let is_listed = find_mistakes_with_hash(hash_picture(yours))
        .iter()
        .any(|(_, name)| name == expected_name);
    let mistake_text =
        explain_listed_mistake(yours, expected_name).filter(|_| is_listed);
    let tests = mistake_text.unwrap_or_else(|| test_command_sentence(&later));
    format!(
        "{start}\n{missing}. (Or the file is that of step {}.)\n{tests}",
        found_step.number()
    )
}

/// Tells which step's picture to check first, where that of an exercise is wrong.
fn hint_to_check_step_first(exercise_name: &str) -> String {
    let Some(step) = which_picture::step_of_exercise(exercise_name) else {
        return String::new();
    };
    let step_name = step.name();
    format!(
        "First ask about step {}'s picture, from which this one is made: cargo run --bin \
         check -- {step_name}.png\n",
        step.number()
    )
}

/// Lines about what went wrong. `ours_at_size` is ours at the size of yours.
fn explain_wrong_picture(
    yours: &Picture,
    ours: &Locked,
    ours_at_size: Option<&RgbImage>,
    step: Option<Step>,
    budget: &RayBudget,
) -> String {
    let name = &ours.name;
    if let Some(text) = explain_one_colour(yours) {
        let steps: Vec<_> =
            Step::ALL.into_iter().filter(|one| Some(*one) <= step).collect();
        let mistake_text = explain_listed_mistake(&yours.pixels, name);
        return text
            + &mistake_text.unwrap_or_else(|| match step {
                Some(_) => test_command_sentence(&steps),
                None => hint_to_check_step_first(name),
            });
    }
    if let Some(part) = crop_or_scale_clause(yours, &ours.picture, ours_at_size) {
        return format!("Not right: your picture is that of {name}, {part}.\n");
    }
    let is_size = yours.size == ours.picture.dimensions();
    let thinned = yours.with_spread_rows(COMPARED);
    let (columns, rows) = yours.size;
    let camera = default_camera(columns.max(2), rows);
    let our_rows = match step {
        _ if is_size => ours.picture.clone(),
        Some(step) => draw_rows(step, &camera, &thinned.rows),
        // Nothing is known of an exercise at another size, but that it may be turned.
        None => RgbImage::new(columns, thinned.rows.len() as u32),
    };
    let evidence = Evidence::new(name, step, &thinned, our_rows, camera, ENCODE);
    let mistake_text =
        if is_size { explain_listed_mistake(&yours.pixels, name) } else { None };
    if evidence.wrong_pixels().is_empty() {
        return explain_difference_beyond_compared_rows(
            yours,
            ours_at_size,
            name,
            thinned.rows.len(),
        );
    }
    let at_size = ours_at_size
        .map(OurPicture::from_drawn)
        .or_else(|| step.map(|step| computed_picture(step, &evidence)));
    let our_pictures =
        at_size.into_iter().chain([OurPicture::from_drawn(&ours.picture)]);
    let rearranged = ours_at_size.map_or(vec![], |ours_at_size| {
        rearranged_candidates(&evidence, ours_at_size)
    });
    let mut text = match find_explanation_of_whole(
        &evidence,
        our_pictures,
        rearranged,
        budget,
    ) {
        Some(found) => {
            let places =
                found.files.iter().filter_map(|file| find_source_ref(file));
            let back = mistake_text
                .unwrap_or_else(|| go_back_sentences(&places.collect::<Vec<_>>()));
            format!(
                "Not right: {}\n{back}",
                lowercase_first_letter(&found.sentence)
            )
        }
        None if is_size || step.is_some() => match mistake_text {
            Some(mistake_text) => {
                format!("Not right: {}", lowercase_first_letter(&mistake_text))
            }
            None => explain_or_count(&evidence, ours_at_size, budget),
        },
        None => {
            return format!(
                "Not right yet, compared with {name}.\n{}",
                hint_on_size(yours, ours)
            );
        }
    };
    if !is_size {
        text += &hint_on_size(yours, ours);
    }
    if is_size || step.is_some() {
        text + &sentences_of_wrong_pixel(&evidence)
    } else {
        text
    }
}

fn hint_on_size(yours: &Picture, ours: &Locked) -> String {
    let ((w, h), (columns, rows)) = (yours.size, ours.picture.dimensions());
    format!(
        "It is {w}×{h} pixels, and ours {columns}×{rows}: draw it with the default \
         options, and more can be told.\n"
    )
}

fn explain_one_colour(yours: &Picture) -> Option<String> {
    let first = yours.pixels.get_pixel_checked(0, 0)?;
    let [r, g, b] = first.0;
    let is_one = yours.pixels.pixels().all(|pixel| pixel == first);
    is_one.then(|| {
        format!("Not right: your picture is one colour, ({r}, {g}, {b}), in all pixels.\n")
    })
}

/// Our picture at the size of the reader's, where that is too large to be drawn.
fn computed_picture<'a>(step: Step, evidence: &'a Evidence) -> OurPicture<'a> {
    let intensity = intensity_function(step, &scene_of_step(step));
    let colour = move |i: u32, j: u32| {
        evidence.encode(intensity(&evidence.camera.ray(i.into(), j.into())))
    };
    OurPicture { size: evidence.yours.size, colour: Rc::new(colour) }
}

/// Lines about a picture that is right in all rows in which explanations are asked.
fn explain_difference_beyond_compared_rows(
    yours: &Picture,
    ours_at_size: Option<&RgbImage>,
    name: &str,
    rows: usize,
) -> String {
    let start = format!("Not right yet, compared with {name}.\n");
    let difference = ours_at_size
        .and_then(|ours_at_size| Difference::between(ours_at_size, &yours.pixels));
    let Some(Difference::Pixels { count, first: (i, j), colours, .. }) = difference
    else {
        return start;
    };
    let [ours, yours_there] =
        [colours.0, colours.1].map(|[r, g, b]| format!("({r}, {g}, {b})"));
    format!(
        "{start}{rows} rows spread over it are right, but {count} of {} pixels differ.\n\
         Column {i}, row {j}: yours is {yours_there}, ours {ours}.\n",
        yours.pixels.pixels().len()
    )
}

/// Finds the first explanation of the whole picture, among the strongest ones.
fn find_explanation_of_whole<'a>(
    evidence: &'a Evidence,
    ours: impl Iterator<Item = OurPicture<'a>>,
    rearranged: Vec<Explanation<'a>>,
    budget: &RayBudget,
) -> Option<Explanation<'a>> {
    let turned_or_swapped = ours.flat_map(|ours| turned_candidates(evidence, ours));
    let strict =
        turned_or_swapped.chain(rearranged).chain(encode_candidates(evidence));
    // In step 1, where all is sky, a camera and another colour of it look like a curve.
    let is_sky_alone = evidence.step == Some(Step::Rays);
    let camera = camera_candidate(evidence).filter(|_| is_sky_alone);
    let colours = sky_colour_candidates(evidence).filter(|_| is_sky_alone);
    let fitted = camera
        .into_iter()
        .chain(factor_and_power_candidates(evidence))
        .chain(colours);
    find_first_that_holds(
        evidence,
        strict.chain(fitted).chain(byte_table_candidate(evidence)),
        budget,
    )
}

/// Lines by the first of the other explanations that holds; or else by counting.
fn explain_or_count(
    evidence: &Evidence,
    ours_at_size: Option<&RgbImage>,
    budget: &RayBudget,
) -> String {
    let candidates = undrawn_pixels_candidate(evidence)
        .into_iter()
        .chain(object_candidates(evidence))
        .chain(changed_number_candidates(evidence))
        .chain(missing_or_doubled_term_candidates(evidence))
        .chain(scaled_term_candidates(evidence))
        .chain(shifted_ray_candidates(evidence))
        .chain(camera_candidate(evidence))
        .chain(sky_colour_candidates(evidence))
        .chain(rounding_candidate(evidence))
        .chain(random_ray_candidate(evidence))
        .chain(recoloured_candidate(evidence))
        .chain(lossy_candidate(evidence));
    if let Some(found) = find_first_that_holds(evidence, candidates, budget) {
        let places = found.files.iter().filter_map(|file| find_source_ref(file));
        let back = go_back_sentences(&places.collect::<Vec<_>>());
        return format!(
            "Not right: {}\n{back}",
            lowercase_first_letter(&found.sentence)
        );
    }
    let start = format!("Not right yet, compared with {}.\n", evidence.name);
    let Some(step) = evidence.step else {
        return start + &hint_to_check_step_first(evidence.name);
    };
    if ours_at_size.is_some() && has_our_colours_elsewhere(evidence) {
        let text = "The pixels of your picture are ours in other places.\n";
        return start + text + &test_command_sentence(&[Step::Rays]);
    }
    match find_other_encode_of_sky(evidence, budget) {
        Some((words, encode)) => {
            let intensity = intensity_function(step, &scene_of_step(step));
            let our_rows = RgbImage::from_fn(
                evidence.ours.width(),
                evidence.ours.height(),
                |i, k| {
                    let j = evidence.yours.rows[k as usize];
                    Rgb(encode(intensity(&evidence.camera.ray(i.into(), j.into()))))
                },
            );
            let Evidence { name, yours, camera, .. } = *evidence;
            let second =
                Evidence::new(name, Some(step), yours, our_rows, camera, encode);
            let further_text = explain_or_count(&second, None, budget);
            format!(
                "{start}In every pixel of the sky each byte of your picture is {words}: see \
                 rgb8.rs of step 1.\nBeside that: {}",
                further_text
                    .trim_start_matches(&start)
                    .trim_start_matches("Not right: ")
            )
        }
        None => start + &describe_wrong_regions(evidence, step, budget),
    }
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
    let Some(most) = wrong.iter().map(Pixel::largest_channel_difference).max()
    else {
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
    let [a, b] =
        [pixel.yours, pixel.ours].map(|[r, g, b]| format!("({r}, {g}, {b})"));
    let (rows, all) = (evidence.yours.rows.len(), evidence.yours.size.1);
    let compared = match rows == all as usize {
        true => String::new(),
        false => format!(" in the {rows} rows compared"),
    };
    format!(
        "{} of {} pixels differ{compared}, by up to {most} of 255.\n\
         Column {}, row {}: yours is {a}, ours {b}{computed}.\n",
        wrong.len(),
        evidence.pixels.len(),
        pixel.i,
        pixel.j,
    )
}
