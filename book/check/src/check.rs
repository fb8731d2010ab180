use crate::listed::listed;
use crate::number::number;
use crate::options::options;
use crate::part::part;
use crate::pixels::Pixels;
use crate::place::back;
use crate::stages::stages;
use crate::table::{known, sum};
use crate::whole::whole;
use crate::{Answer, Locked, Step, camera, classes, png, whose};
use compare::{Difference, apart, panels};
use image::RgbImage;
use std::io::{BufRead, Seek};

/// The most pixels of a picture that is shown beside ours.
const MOST: usize = 1 << 22;

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
        Ok((picture, notes)) => {
            let names = locked.iter().map(|one| one.name.as_str());
            let name = name.or_else(|| whose::by_file(file, names));
            let mut answer = look(&picture, name, locked);
            if answer.code < 2 && !notes.is_empty() {
                answer.text = format!("{}\n{}", answer.text, notes.trim_end());
            }
            answer
        }
        Err(what) => Answer::new(2, format!("error: {file} {what}")),
    }
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn look(yours: &RgbImage, name: Option<&str>, locked: &[Locked]) -> Answer {
    let is_asked = |one: &&Locked| name.is_none_or(|name| name == one.name);
    let asked: Vec<_> = locked.iter().filter(is_asked).collect();
    if asked.is_empty() {
        let names: Vec<_> = locked.iter().map(|one| one.name.as_str()).collect();
        let name = name.unwrap_or_default();
        let names = names.join(", ");
        let text = format!(
            "error: there is no locked picture '{name}'; allowed are {names}"
        );
        return Answer::new(2, text);
    }
    if let Some(one) = asked.iter().find(|one| one.picture == *yours) {
        let name = &one.name;
        let text = format!("Right: this is the picture of {name}, in every pixel.");
        return Answer::new(0, text);
    }
    let ours = whose::nearest(yours, &asked);
    let step = Step::named(&ours.name).filter(|_| 2 <= yours.width());
    if let Some(text) = step.and_then(|step| options(step, yours, &ours.picture)) {
        return Answer::new(1, text);
    }
    let same = locked.iter().find(|one| one.picture == *yours);
    let text = match same {
        Some(other) => another(yours, ours, other, step),
        None => told(yours, ours, step),
    };
    let Some(drawn) = shown(yours, ours, step) else {
        return Answer::new(1, text.trim_end().to_owned());
    };
    let is_size = yours.dimensions() == ours.picture.dimensions();
    let text = text + &pixel(yours, &drawn, step.filter(|_| is_size));
    let difference = Some(panels([("yours", yours), ("ours", &drawn)]));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
}

/// Ours at the size of yours, if that is not too large to be shown.
fn shown(yours: &RgbImage, ours: &Locked, step: Option<Step>) -> Option<RgbImage> {
    let (columns, rows) = yours.dimensions();
    if (columns, rows) == ours.picture.dimensions() {
        return Some(ours.picture.clone());
    }
    let step = step.filter(|_| yours.pixels().len() <= MOST)?;
    Some(step.picture(&camera(columns, rows), 1))
}

/// What there is to say of a picture that is right elsewhere.
fn another(
    yours: &RgbImage,
    ours: &Locked,
    other: &Locked,
    step: Option<Step>,
) -> String {
    let (name, asked) = (&other.name, &ours.name);
    let start =
        format!("Not right: this is the picture of {name}, not of {asked}.\n");
    // Where no ray meets an object, every step draws that of the first.
    let step = step.filter(|_| name == Step::Rays.name());
    let first = step.map(|step| stages(&Pixels::new(step, yours, &ours.picture)));
    let is_listed = known(sum(yours)).iter().any(|(_, of)| of == asked);
    let listed = listed(yours, asked).filter(|_| is_listed);
    start + &listed.or(first).unwrap_or_default()
}

/// What went wrong.
fn told(yours: &RgbImage, ours: &Locked, step: Option<Step>) -> String {
    let name = &ours.name;
    let is_size = yours.dimensions() == ours.picture.dimensions();
    let start = format!("Not right yet, compared with {name}.\n");
    let whole = whole(yours, ours);
    let listed = listed(yours, name);
    if let Some(whole) = whole {
        let text = format!("Not right: your picture is {}.\n", whole.text);
        let back = whole.place.map_or(String::new(), |place| back(&[place]));
        return text + &listed.unwrap_or(back);
    }
    if let Some(listed) = listed {
        return listed;
    }
    if !is_size {
        let small = yours.pixels().len() <= MOST;
        let drawn = step
            .filter(|_| small)
            .map(|step| step.picture(&camera(yours.width(), yours.height()), 1));
        let part =
            if small { part(yours, &ours.picture, drawn.as_ref()) } else { None };
        if let Some(part) = part {
            return format!("Not right: your picture is that of {name}, {part}.\n");
        }
        let (w, h) = yours.dimensions();
        let (columns, rows) = ours.picture.dimensions();
        return format!(
            "{start}It is {w}×{h} pixels, and ours {columns}×{rows}: draw it with the \
             default options, and more can be told.\n"
        );
    }
    let Some(step) = step else {
        return start;
    };
    if let Some(found) = number(step, yours, &ours.picture) {
        let back = found.place.map_or(String::new(), |place| back(&[place]));
        return format!("Not right: {}{back}", found.text);
    }
    start + &stages(&Pixels::new(step, yours, &ours.picture))
}

/// One pixel that is wrong, the one in the middle of those, and how many there are.
fn pixel(yours: &RgbImage, ours: &RgbImage, step: Option<Step>) -> String {
    let Some(Difference::Pixels { count, largest, .. }) =
        Difference::between(ours, yours)
    else {
        return String::new();
    };
    let pairs = yours.enumerate_pixels().zip(ours.pixels());
    let far = |a, b| apart(a, b) >= largest.div_ceil(2);
    let mut wrong = pairs.filter(|((.., a), b)| far(a, b)).collect::<Vec<_>>();
    let Some(((i, j, a), b)) = wrong.get(wrong.len() / 2).copied() else {
        return String::new();
    };
    wrong.clear();
    let camera = camera(yours.width().max(2), yours.height().max(1));
    let computed = step.map_or(String::new(), |step| {
        let ray = camera.ray(i.into(), j.into());
        format!(": {}", classes::computed(step, &ray))
    });
    format!(
        "{count} of {} pixels differ, by up to {largest} of 255.\n\
         Column {i}, row {j}: yours is {}, ours {}{computed}.\n",
        yours.pixels().len(),
        bytes(a.0),
        bytes(b.0),
    )
}

fn bytes([r, g, b]: [u8; 3]) -> String {
    format!("({r}, {g}, {b})")
}
