use crate::case::Case;
use crate::kind::kind;
use crate::options::{Options, options};
use crate::png::{self, Notes};
use crate::told::{Told, objects, one_pixel};
use crate::verdict::verdict;
use crate::view::View;
use crate::{
    Answer, Cause, Found, Locked, Rest, Step, panels, section, sight, whose,
};
use image::RgbImage;
use std::io::{BufRead, Seek};

/// Compares the picture in a PNG file with the locked picture `name`; where that is
/// left out, with the one that the file's own name tells, or else with the nearest.
///
/// It takes nothing but what it is given: no file, no argument, no time.
pub fn check(
    mut png: impl BufRead + Seek,
    file: &str,
    name: Option<&str>,
    locked: &[Locked],
) -> Answer {
    match png::read(&mut png) {
        Ok((view, notes)) => {
            let names = locked.iter().map(|one| one.name.as_str());
            let name = name.or_else(|| whose::by_file(file, names));
            answer(&view, name, locked, &notes, |cause| {
                png.rewind().ok()?;
                png::rest(&mut png, cause).ok()
            })
        }
        Err(what) => Answer::refused(format!("{file} {what}")),
    }
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn look(yours: &RgbImage, name: Option<&str>, locked: &[Locked]) -> Answer {
    let view = View::whole(yours.clone());
    answer(&view, name, locked, &Notes::default(), |_| None)
}

/// `recount` looks at all pixels of a picture of which only some are kept.
fn answer(
    yours: &View,
    name: Option<&str>,
    locked: &[Locked],
    notes: &Notes,
    recount: impl FnOnce(&Cause) -> Option<Rest>,
) -> Answer {
    let is_asked = |one: &&Locked| name.is_none_or(|name| name == one.name);
    let asked: Vec<_> = locked.iter().filter(is_asked).collect();
    if asked.is_empty() {
        return Answer::refused(unknown(name, locked));
    }
    let is_same = |one: &Locked| yours.stride == 1 && one.picture == yours.kept;
    if let Some(Locked { name, .. }) = asked.iter().find(|one| is_same(one)) {
        let right =
            format!("Right: this is the picture of {name}, in every pixel.");
        let text = format!("{right}\n{}", notes.text);
        return Answer::new(0, text.trim_end().to_owned());
    }
    let same = locked.iter().find(|one| is_same(one));
    let mut case = Case::of(yours, &asked, same);
    case.recount(recount);
    let start = broken(&case) + &notes.text;
    let is_known = same.is_some() || case.is_explained();
    let kind = if is_known { None } else { kind(yours, &asked, notes) };
    match kind {
        Some(kind) => Answer::new(1, (start + &kind).trim_end().to_owned()),
        None => measured(case, start),
    }
}

/// What there is to say of a picture that is not right.
fn measured(mut case: Case, mut text: String) -> Answer {
    let step = case.step.filter(|_| case.same.is_none() && 2 <= case.yours.size.0);
    let step = step.filter(|_| !(case.is_nearly_right() && case.has_strays_only()));
    let is_whole = case.yours.stride == 1;
    let stages = step.filter(|_| is_whole);
    let stages = stages.map(|step| Told::of(&mut case, step));
    // What seems to be rounded, but shows a wrong stage, is not nearly right.
    let is_wrong = stages.as_ref().is_some_and(|stages| stages.is_wrong);
    let is_few = |found: &Found| found.rest.is_few(0);
    if is_wrong
        && case.is_nearly_right()
        && !case.found.as_ref().is_some_and(is_few)
    {
        case.found = None;
    }
    text += &one_colour(&case);
    text += &told(&case);
    let found = case.found.as_ref().map(Found::options);
    let drawn_with = found.or(stages.as_ref().map(|stages| stages.options));
    let drawn_with = drawn_with.unwrap_or(Options::NONE);
    text += &options(case.yours.size, case.ours.picture.dimensions(), drawn_with);
    text += &stages.map_or(String::new(), |stages| stages.text);
    if step.is_some() && !is_whole {
        text += "It is too large to be measured stage by stage; a smaller one tells more.\n";
    }
    let ours = case.drawn(drawn_with);
    if let Some(ours) = &ours {
        let yours = &case.yours.kept;
        let step = step.filter(|_| is_whole);
        let pixel = |step| one_pixel(yours, ours, step, drawn_with);
        text += &step.map_or(String::new(), pixel);
        text += &differences(&case, ours);
    }
    let difference =
        ours.map(|ours| panels([("yours", &case.yours.kept), ("ours", &ours)]));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
}

/// Says that there is no such name, and which there are.
fn unknown(name: Option<&str>, locked: &[Locked]) -> String {
    let names: Vec<_> = locked.iter().map(|one| one.name.as_str()).collect();
    let name =
        name.map(|name| format!(" '{name}'; allowed are {}", names.join(", ")));
    format!("there is no locked picture{}", name.unwrap_or_default())
}

/// Says that our own code is wrong, where it is.
fn broken(case: &Case) -> String {
    if case.broken.is_empty() {
        return String::new();
    }
    let names: Vec<_> = case.broken.iter().map(|step| step.name()).collect();
    format!(
        "The code in our folder does not draw the locked picture of {} any more. Mend \
         it first; until then, few mistakes can be told.\n",
        names.join(", ")
    )
}

/// Says which colour it is, where there is only one.
fn one_colour(case: &Case) -> String {
    case.yours.flat().map_or(String::new(), |colour| {
        let is_all = |byte: u8| colour.0 == [byte; 3];
        let why = match (is_all(0), is_all(255)) {
            (true, _) => {
                " Each intensity is at most 0 there, or no number, as 0 / 0 is none."
            }
            (_, true) => " Each intensity is at least 1 there.",
            _ => "",
        };
        let all = match case.yours.kept.pixels().all(|pixel| *pixel == colour) {
            true => "",
            false => " in nearly all pixels",
        };
        format!("It has one colour only{all}: {:?}.{why}\n", colour.0)
    })
}

/// Whether another picture or a known mistake explains it.
fn told(case: &Case) -> String {
    let name = &case.ours.name;
    let same = case.same.map_or(String::new(), |same| {
        let same = &same.name;
        let why = no_highlights(case, same);
        format!(
            "Not right yet: this is the picture of {same}, not of {name}.\n{why}"
        )
    });
    let is_told = case.yours.flat().is_some() || !case.broken.is_empty();
    let but = if is_told { "" } else { ", and no known mistake gives it" };
    match &case.found {
        Some(found) => same + &verdict(found) + no_hit(case),
        None if case.same.is_some() => same,
        None => format!("Not right yet: this is not the picture of {name}{but}.\n"),
    }
}

/// Says where highlights may be lost, where the picture of step 4 stands for that of the
/// last step.
fn no_highlights(case: &Case, same: &str) -> String {
    let is_lit = same == Step::Diffuse.name() && case.step == Some(Step::Phong);
    let [sum, term] = [section::SUM, section::SPECULAR].map(|one| one.path());
    match is_lit {
        true => format!(
            "No highlight is in it: I_s is not in the sum, or nothing lets it in, as where \
             0 < n·l is another condition ({sum}), or it is 0 everywhere ({term}).\n"
        ),
        false => String::new(),
    }
}

/// Says that no ray meets anything, which very many slips give.
fn no_hit(case: &Case) -> &'static str {
    let Some(step) = case.step.filter(|step| *step != Step::Rays) else {
        return "";
    };
    let is_explained = case.is_explained() && !case.is_nearly_right();
    let cause = case.found.as_ref().filter(|_| is_explained);
    let Some(cause) = cause.map(|found| found.cause(step)) else { return "" };
    match objects(case, &cause).contains(&true) {
        false => {
            "No ray meets anything in it. Other slips in a, b, c, D or the roots give the \
             same picture, such as + r² for − r² in c, no r² there, or b for b² in D; the \
             tests of steps/step02_sphere/tests/by_hand.rs tell them apart.\n"
        }
        true => "",
    }
}

/// Says how two pictures of one size differ.
fn differences(case: &Case, ours: &RgbImage) -> String {
    let mut text = match case.found {
        None => sight::seen(case.yours, ours, case.step),
        _ => sight::region(case.yours, ours),
    };
    if case.is_nearly_right() && text.contains("by up to 1 of 255") {
        text += "That may be rounding, as of numbers with fewer digits than f64.\n";
    }
    text
}
