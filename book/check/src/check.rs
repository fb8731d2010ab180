use crate::byte_curve::{
    encodes, fitted_factor_and_power, other_encode_of_sky, table,
};
use crate::camera_from_sky::{fitted_camera, sky_colours};
use crate::crop_or_scale::describe_crop_or_scale;
use crate::disturbed::{
    last_digits, lossy, other_places, random_places, recoloured,
};
use crate::evidence::{Evidence, Pixel};
use crate::explanation::{Explanation, Work, first_that_holds};
use crate::listed_mistake::listed_mistake;
use crate::missing_parts::{never_drawn, other_objects, other_terms, scaled_terms};
use crate::other_options::{draw_rows, other_options};
use crate::pixel_regions::computed;
use crate::scene_parameter::other_numbers;
use crate::source_ref::{back, place, test_command};
use crate::step_scene::{ENCODE, intensity, scene};
use crate::transformed::{OurPicture, has_same_pixels, rearranged, turned};
use crate::wrong_regions::wrong_regions;
use crate::{
    Answer, Locked, Picture, Step, camera, known, png_file, printable, sum,
    which_picture,
};
use compare::{Difference, panels};
use image::{Rgb, RgbImage};
use std::rc::Rc;

/// The most pixels in which explanations are asked: those of a locked picture.
const COMPARED: u32 = 640 * 360;

/// How many rays may be computed for an answer.
const RAYS: u32 = 4_000_000;

/// Compares the picture in a PNG file with the locked picture `name`; where that is
/// left out, with the one that the file's own name tells, or else with the nearest.
///
/// It takes nothing but what it is given: no file, no argument, no time.
pub fn check(
    png: &[u8],
    file: &str,
    name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    match png_file::read(png) {
        Ok(picture) => {
            let names = locked.iter().map(|one| one.name.as_str());
            let name = name.or_else(|| which_picture::by_file(file, names));
            let mut answer = compare_with_ours(&picture, name, locked);
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
        Err(what) => Answer::new(2, format!("error: {} {what}", printable(file))),
    }
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn look(yours: &RgbImage, name: Option<&str>, locked: &[Locked]) -> Answer {
    compare_with_ours(&Picture::whole(yours.clone()), name, locked)
}

fn compare_with_ours(
    yours: &Picture,
    name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    let is_asked = |one: &&Locked| name.is_none_or(|name| name == one.name);
    let asked: Vec<_> = locked.iter().filter(is_asked).collect();
    if asked.is_empty() {
        let names: Vec<_> = locked.iter().map(|one| one.name.as_str()).collect();
        let (name, names) = (printable(name.unwrap_or_default()), names.join(", "));
        let text = format!(
            "error: there is no locked picture '{name}'; allowed are {names}"
        );
        return Answer::new(2, text);
    }
    let is_this = |one: &&&Locked| yours.is_whole() && one.picture == yours.pixels;
    let right = asked.iter().find(is_this);
    let ours = right
        .copied()
        .unwrap_or_else(|| which_picture::nearest(&yours.pixels, &asked));
    if !ours.is_of_this_version() {
        let text = format!(
            "error: our picture of {} is of another version of the course than this program",
            ours.name
        );
        return Answer::new(2, text);
    }
    if right.is_some() {
        let name = &ours.name;
        let text = format!("Right: this is the picture of {name}, in every pixel.");
        return Answer::new(0, text);
    }
    let work = Work::new(RAYS);
    let step = Step::named(&ours.name).filter(|_| 2 <= yours.size.0);
    if let Some((step, options)) =
        step.and_then(|step| Some((step, other_options(step, yours, &work)?)))
    {
        let is_right = options.are_default() && !yours.is_whole();
        return Answer::new(u8::from(!is_right), options.sentence(step, yours));
    }
    let is_size = yours.size == ours.picture.dimensions();
    let drawn = match step.filter(|_| yours.is_whole()) {
        _ if is_size => Some(ours.picture.clone()),
        Some(step) => Some(step.picture(&camera(yours.size.0, yours.size.1), 1)),
        None => None,
    };
    let same = locked.iter().find(|one| is_this(&one));
    let text = match same {
        Some(other) => another_picture(&yours.pixels, ours, other),
        None => explain(yours, ours, drawn.as_ref(), step, &work),
    };
    let difference = drawn.map(|drawn| panels(&yours.pixels, &drawn));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
}

/// What there is to say of a picture that is right elsewhere.
fn another_picture(yours: &RgbImage, ours: &Locked, other: &Locked) -> String {
    let (name, asked) = (&other.name, &ours.name);
    let start =
        format!("Not right: this is the picture of {name}, not of {asked}.");
    let steps = [name, asked].map(|name| Step::named(name));
    let [Some(from), Some(to)] = steps else {
        return format!("{start}\n{}", exercise_hint(asked));
    };
    let missing = match (from, to) {
        _ if to < from => return start,
        (Step::Diffuse, _) => "The highlights are missing",
        (Step::Nearest, _) => "The light is missing: each object has one colour",
        (Step::Rays, _) => "The objects are missing: no ray meets one",
        _ => "The nine objects are missing",
    };
    let later = Step::ALL.into_iter().filter(|step| from < *step && *step <= to);
    let later: Vec<_> = later.collect();
    let is_listed = known(sum(yours)).iter().any(|(_, name)| name == asked);
    let listed = listed_mistake(yours, asked).filter(|_| is_listed);
    let tests = listed.unwrap_or_else(|| test_command(&later));
    format!(
        "{start}\n{missing}. (Or the file is that of step {}.)\n{tests}",
        from.number()
    )
}

/// The step whose picture is to be asked first, where that of an exercise is wrong.
fn exercise_hint(name: &str) -> String {
    let Some(step) = which_picture::step_of_exercise(name) else {
        return String::new();
    };
    let step_name = step.name();
    format!(
        "First ask about step {}'s picture, from which this one is made: cargo run --bin \
         check -- {step_name}.png\n",
        step.number()
    )
}

/// What went wrong. `drawn` is ours at the size of yours.
fn explain(
    yours: &Picture,
    ours: &Locked,
    drawn: Option<&RgbImage>,
    step: Option<Step>,
    work: &Work,
) -> String {
    let name = &ours.name;
    if let Some(text) = one_colour(yours) {
        let steps: Vec<_> =
            Step::ALL.into_iter().filter(|one| Some(*one) <= step).collect();
        let listed = listed_mistake(&yours.pixels, name);
        return text
            + &listed.unwrap_or_else(|| match step {
                Some(_) => test_command(&steps),
                None => exercise_hint(name),
            });
    }
    if let Some(part) = describe_crop_or_scale(yours, &ours.picture, drawn) {
        return format!("Not right: your picture is that of {name}, {part}.\n");
    }
    let is_size = yours.size == ours.picture.dimensions();
    let thinned = yours.thinned(COMPARED);
    let (columns, rows) = yours.size;
    let camera = camera(columns.max(2), rows);
    let own = match step {
        _ if is_size => ours.picture.clone(),
        Some(step) => draw_rows(step, &camera, &thinned.rows),
        // Nothing is known of an exercise at another size, but that it may be turned.
        None => RgbImage::new(columns, thinned.rows.len() as u32),
    };
    let evidence = Evidence::new(name, step, &thinned, own, camera, ENCODE);
    let listed = if is_size { listed_mistake(&yours.pixels, name) } else { None };
    if evidence.wrong().is_empty() {
        return sentence_beyond_compared_rows(
            yours,
            drawn,
            name,
            thinned.rows.len(),
        );
    }
    let at_size = drawn
        .map(OurPicture::of)
        .or_else(|| step.map(|step| computed_picture(step, &evidence)));
    let whole = at_size.into_iter().chain([OurPicture::of(&ours.picture)]);
    let rearranged = drawn.map_or(vec![], |drawn| rearranged(&evidence, drawn));
    let mut text = match explain_whole(&evidence, whole, rearranged, work) {
        Some(found) => {
            let places = found.files.iter().filter_map(|file| place(file));
            let back = listed.unwrap_or_else(|| back(&places.collect::<Vec<_>>()));
            format!("Not right: {}\n{back}", lower_first(&found.sentence))
        }
        None if is_size || step.is_some() => match listed {
            Some(listed) => format!("Not right: {}", lower_first(&listed)),
            None => explain_rest(&evidence, drawn, work),
        },
        None => {
            return format!(
                "Not right yet, compared with {name}.\n{}",
                size_hint(yours, ours)
            );
        }
    };
    if !is_size {
        text += &size_hint(yours, ours);
    }
    if is_size || step.is_some() {
        text + &sentence_of_pixel(&evidence)
    } else {
        text
    }
}

fn size_hint(yours: &Picture, ours: &Locked) -> String {
    let ((w, h), (columns, rows)) = (yours.size, ours.picture.dimensions());
    format!(
        "It is {w}×{h} pixels, and ours {columns}×{rows}: draw it with the default \
         options, and more can be told.\n"
    )
}

fn one_colour(yours: &Picture) -> Option<String> {
    let first = yours.pixels.get_pixel_checked(0, 0)?;
    let [r, g, b] = first.0;
    let is_one = yours.pixels.pixels().all(|pixel| pixel == first);
    is_one.then(|| {
        format!("Not right: your picture is one colour, ({r}, {g}, {b}), in all pixels.\n")
    })
}

/// Our picture at the size of the reader's, where that is too large to be drawn.
fn computed_picture<'a>(step: Step, evidence: &'a Evidence) -> OurPicture<'a> {
    let intensity = intensity(step, &scene(step));
    let colour = move |i: u32, j: u32| {
        evidence.encode(intensity(&evidence.camera.ray(i.into(), j.into())))
    };
    OurPicture { size: evidence.yours.size, colour: Rc::new(colour) }
}

/// What there is to say where all rows are right in which explanations are asked.
fn sentence_beyond_compared_rows(
    yours: &Picture,
    drawn: Option<&RgbImage>,
    name: &str,
    rows: usize,
) -> String {
    let start = format!("Not right yet, compared with {name}.\n");
    let difference =
        drawn.and_then(|drawn| Difference::between(drawn, &yours.pixels));
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

/// What was made of ours as a whole: the strongest explanations.
fn explain_whole<'a>(
    evidence: &'a Evidence,
    ours: impl Iterator<Item = OurPicture<'a>>,
    rearranged: Vec<Explanation<'a>>,
    work: &Work,
) -> Option<Explanation<'a>> {
    let turned = ours.flat_map(|ours| turned(evidence, ours));
    let strict = turned.chain(rearranged).chain(encodes(evidence));
    // In step 1, where all is sky, a camera and another colour of it look like a curve.
    let is_sky_alone = evidence.step == Some(Step::Rays);
    let camera = fitted_camera(evidence).filter(|_| is_sky_alone);
    let colours = sky_colours(evidence).filter(|_| is_sky_alone);
    let fitted =
        camera.into_iter().chain(fitted_factor_and_power(evidence)).chain(colours);
    first_that_holds(evidence, strict.chain(fitted).chain(table(evidence)), work)
}

/// What explains a picture that is not in the list; or what there is to count.
fn explain_rest(
    evidence: &Evidence,
    drawn: Option<&RgbImage>,
    work: &Work,
) -> String {
    let one = never_drawn(evidence)
        .into_iter()
        .chain(other_objects(evidence))
        .chain(other_numbers(evidence))
        .chain(other_terms(evidence))
        .chain(scaled_terms(evidence))
        .chain(other_places(evidence))
        .chain(fitted_camera(evidence))
        .chain(sky_colours(evidence))
        .chain(last_digits(evidence))
        .chain(random_places(evidence))
        .chain(recoloured(evidence))
        .chain(lossy(evidence));
    if let Some(found) = first_that_holds(evidence, one, work) {
        let places = found.files.iter().filter_map(|file| place(file));
        let back = back(&places.collect::<Vec<_>>());
        return format!("Not right: {}\n{back}", lower_first(&found.sentence));
    }
    let start = format!("Not right yet, compared with {}.\n", evidence.name);
    let Some(step) = evidence.step else {
        return start + &exercise_hint(evidence.name);
    };
    if drawn.is_some() && has_same_pixels(evidence) {
        let text = "The pixels of your picture are ours in other places.\n";
        return start + text + &test_command(&[Step::Rays]);
    }
    match other_encode_of_sky(evidence, work) {
        Some((words, encode)) => {
            let intensity = intensity(step, &scene(step));
            let own = RgbImage::from_fn(
                evidence.ours.width(),
                evidence.ours.height(),
                |i, k| {
                    let j = evidence.yours.rows[k as usize];
                    Rgb(encode(intensity(&evidence.camera.ray(i.into(), j.into()))))
                },
            );
            let Evidence { name, yours, camera, .. } = *evidence;
            let second =
                Evidence::new(name, Some(step), yours, own, camera, encode);
            let rest = explain_rest(&second, None, work);
            format!(
                "{start}In every pixel of the sky each byte of your picture is {words}: see \
                 rgb8.rs of step 1.\nBeside that: {}",
                rest.trim_start_matches(&start).trim_start_matches("Not right: ")
            )
        }
        None => start + &wrong_regions(evidence, step, work),
    }
}

/// A sentence as it goes on after a colon.
fn lower_first(sentence: &str) -> String {
    let mut letters = sentence.chars();
    let first = letters.next().map(|c| c.to_lowercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// One pixel that is wrong, among those that differ most, and how many there are.
fn sentence_of_pixel(evidence: &Evidence) -> String {
    let wrong = evidence.wrong();
    let Some(most) = wrong.iter().map(Pixel::distance).max() else {
        return String::new();
    };
    let mut far: Vec<_> =
        wrong.iter().filter(|pixel| most.div_ceil(2) <= pixel.distance()).collect();
    far.sort_by_key(|pixel| (pixel.j, pixel.i));
    let pixel = far[far.len() / 2];
    let computed = evidence.step.map_or(String::new(), |step| {
        format!(": {}", computed(step, &evidence.ray(pixel)))
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
