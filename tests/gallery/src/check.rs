use crate::difference::apart;
use crate::options::options;
use crate::recognise::{RAYS, ROUNDING};
use crate::told::{Told, one_pixel};
use crate::verdict::verdict;
use crate::view::View;
use crate::{
    Answer, Difference, Found, Locked, Mistake, Rest, Step, camera, mistakes, png,
    recognise, sight, whose,
};
use image::RgbImage;
use std::io::{BufRead, Seek};

/// Compares the picture in a PNG file with the locked picture `name`; where that is
/// left out, with the one that the file's own name tells, or else with the nearest.
///
/// It takes nothing but what it is given: no file, no argument, no time.
pub fn check(
    png: impl BufRead + Seek,
    file: &str,
    name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    match png::read(png) {
        Ok((view, kind)) => {
            let name = name.or_else(|| whose::by_file(file, locked));
            answer(&view, name, locked, &kind)
        }
        Err(what) => Answer::refused(format!("{file} {what}")),
    }
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn look(yours: &RgbImage, name: Option<&str>, locked: &[Locked]) -> Answer {
    answer(&View::whole(yours.clone()), name, locked, &[])
}

fn answer(
    yours: &View,
    name: Option<&str>,
    locked: &[Locked],
    kind: &[&str],
) -> Answer {
    let is_asked = |one: &&Locked| name.is_none_or(|name| name == one.name);
    let asked: Vec<_> = locked.iter().filter(is_asked).collect();
    if asked.is_empty() {
        let names: Vec<_> = locked.iter().map(|one| one.name.as_str()).collect();
        let name = name.map(|name| format!("'{name}'; allowed are "));
        return Answer::refused(format!(
            "there is no locked picture {}{}",
            name.unwrap_or_default(),
            names.join(", ")
        ));
    }
    let is_same = |one: &Locked| yours.stride == 1 && one.picture == yours.kept;
    let kind: String = kind.iter().map(|told| format!("{told}\n")).collect();
    if let Some(one) = asked.iter().find(|one| is_same(one)) {
        let name = &one.name;
        let text = format!(
            "Right: this is the picture of {name}, in every pixel.\n{kind}"
        );
        return Answer::new(0, text.trim_end().to_owned());
    }
    let same = locked.iter().find(|one| is_same(one));
    compared(yours, &asked, same, kind)
}

/// What there is to say of a picture that is none of those `asked` for.
fn compared(
    yours: &View,
    asked: &[&Locked],
    same: Option<&Locked>,
    kind: String,
) -> Answer {
    let steps =
        asked.iter().filter_map(|one| Some((*one, Step::named(&one.name)?)));
    let (broken, steps): (Vec<_>, Vec<_>) =
        steps.partition(|(one, step)| is_broken(one, *step));
    let is = |list: &[(&Locked, Step)], name: &str| {
        list.iter().any(|(one, _)| one.name == name)
    };
    let known: Vec<_> = steps.iter().map(|(_, step)| *step).collect();
    // What is right elsewhere is not nearly something else here.
    let is_clear = |found: &Found| found.rest.is_none() || same.is_none();
    let found = recognise(yours, &known)
        .or_else(|| asked.iter().find_map(|ours| turned(yours, ours)))
        .filter(is_clear);
    let is_found =
        |one: &&&Locked| found.as_ref().is_none_or(|found| found.name == one.name);
    let nearest = asked.iter().filter(is_found);
    let nearest = nearest.min_by_key(|ours| whose::distance(yours, ours));
    let ours = nearest.unwrap_or(&asked[0]);
    let step = Step::named(&ours.name).filter(|_| !is(&broken, &ours.name));

    let mut text = told_of(&broken) + &kind;
    if let Some(Locked { name: same, .. }) = same {
        text += &format!(
            "Not right yet: this is the picture of {same}, not of {}.\n",
            ours.name
        );
    }
    let is_all = found.as_ref().is_some_and(|found| found.rest.is_none());
    let is_right = is_all && found.as_ref().is_some_and(is_right);
    let stages = step.filter(|_| !is_right && same.is_none() && 2 <= yours.size.0);
    let stages = stages.map(|step| Told::of(&yours.kept, step));
    // What is nearly right, but shows a wrong stage, is not right.
    let is_wrong = stages.as_ref().is_some_and(|stages| stages.is_wrong);
    let found = found.filter(|found| !is_wrong || !self::is_right(found));
    match &found {
        Some(found) => text += &verdict(found),
        None if same.is_some() => {}
        None => {
            let but = match yours.flat().is_some() || !broken.is_empty() {
                true => "",
                false => ", and no known mistake gives it",
            };
            let name = &ours.name;
            text += &format!(
                "Not right yet: this is not the picture of {name}{but}.\n"
            );
        }
    }
    text += &one_colour(yours);
    text += &options(yours.size, ours.picture.dimensions(), found.as_ref());
    text += &stages.map_or(String::new(), |stages| stages.text);
    let ours = match is_right {
        true => None,
        false => ours_at(yours, &ours.picture, step, found.as_ref()),
    };
    if let Some(ours) = &ours {
        text +=
            &step.map_or(String::new(), |step| one_pixel(&yours.kept, ours, step));
        text += &differences(yours, ours, step, found.as_ref(), is_wrong);
    }
    let difference = ours.map(|ours| Difference::picture(&yours.kept, &ours));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
}

/// Whether the code of a step does not draw its locked picture.
fn is_broken(ours: &Locked, step: Step) -> bool {
    let (width, height) = ours.picture.dimensions();
    step.picture(&camera(width, height), 1) != ours.picture
}

/// Says that our own code is wrong, where it is.
fn told_of(broken: &[(&Locked, Step)]) -> String {
    if broken.is_empty() {
        return String::new();
    }
    let names: Vec<_> = broken.iter().map(|(one, _)| one.name.as_str()).collect();
    format!(
        "The code in our folder does not draw the locked picture of {} any more. Mend \
         it first; until then, few mistakes can be told.\n",
        names.join(", ")
    )
}

/// The mistakes that can be told from two pictures alone: those of an exercise too.
fn turned(yours: &View, ours: &Locked) -> Option<Found> {
    let (width, height) = ours.picture.dimensions();
    if yours.size != (width, height) {
        return None;
    }
    let rest = |[is_down, is_left, is_swapped]: [bool; 3]| {
        let mut rest = Rest::new(yours.pixels());
        for (i, j, yours) in yours.kept.enumerate_pixels() {
            let i = if is_left { width - 1 - i } else { i };
            let j = if is_down { height - 1 - j } else { j };
            let mut ours = *ours.picture.get_pixel(i, j);
            if is_swapped {
                ours.0.reverse();
            }
            rest.add(apart(yours, &ours));
        }
        rest
    };
    let choices = (0..8).map(|bits| [1, 2, 4].map(|bit| bits & bit != 0));
    let rests = choices.map(|choice| (choice, rest(choice)));
    let (choice, rest) = rests.min_by_key(|(_, rest)| rest.beyond(ROUNDING))?;
    let chosen = |one: &&Mistake| {
        let mut names = ["y-down", "mirrored", "bgr"].iter().zip(choice);
        names.any(|(name, is_chosen)| is_chosen && *name == one.name)
    };
    let causes = vec![mistakes().filter(chosen).collect()];
    let name = ours.name.clone();
    rest.is_few(ROUNDING).then_some(Found { name, samples: 1, causes, rest })
}

/// Says which colour it is, where there is only one.
fn one_colour(yours: &View) -> String {
    yours.flat().map_or(String::new(), |colour| {
        let all = match yours.kept.pixels().all(|pixel| *pixel == colour) {
            true => "",
            false => " in nearly all pixels",
        };
        format!("It has one colour only{all}: {:?}.\n", colour.0)
    })
}

/// Our picture at the size of the reader's, where there is anything to show: a step's
/// own is drawn anew at another size.
fn ours_at(
    yours: &View,
    ours: &RgbImage,
    step: Option<Step>,
    found: Option<&Found>,
) -> Option<RgbImage> {
    let (width, height) = yours.size;
    if (width, height) == ours.dimensions() {
        return Some(ours.clone());
    }
    // More rays a pixel are not worth the wait, except for a small picture.
    let samples = found.map_or(1, |found| found.samples);
    let is_small = u64::from(width) * u64::from(height) * 256 <= RAYS;
    let samples = if is_small { samples } else { 1 };
    let step = step.filter(|_| 2 <= width)?;
    let parts = crate::Parts::right(&camera(width, height));
    let (columns, rows) = yours.kept.dimensions();
    Some(RgbImage::from_fn(columns, rows, |i, j| {
        parts.pixel(step, samples, i * yours.stride, j * yours.stride)
    }))
}

/// Whether nothing is wrong with the picture but its size, its rays, or single pixels.
fn is_right(found: &Found) -> bool {
    found.causes[0].is_empty()
}

/// Says how two pictures of one size differ.
fn differences(
    yours: &View,
    ours: &RgbImage,
    step: Option<Step>,
    found: Option<&Found>,
    is_wrong: bool,
) -> String {
    let mut text = match found {
        None => sight::seen(yours, ours, step),
        _ => sight::region(yours, ours),
    };
    let is_right = !is_wrong && found.is_some_and(is_right);
    if is_right && text.contains("by up to 1 of 255") {
        text += "That is rounding, as of numbers with fewer digits than f64.\n";
    }
    text
}
