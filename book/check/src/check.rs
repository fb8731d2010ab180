use crate::listed::listed;
use crate::number::number;
use crate::options::options;
use crate::part::part;
use crate::place::back;
use crate::seen::computed;
use crate::stages::stages;
use crate::table::{known, sum};
use crate::whole::whole;
use crate::{Answer, Locked, Step, camera, png, whose};
use compare::{Difference, apart, panels};
use image::RgbImage;

/// The most pixels of a picture that is shown beside ours.
const MOST: usize = 1 << 22;

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
        let (name, names) = (name.unwrap_or_default(), names.join(", "));
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
    let is_size = yours.dimensions() == ours.picture.dimensions();
    let drawn = match step.filter(|_| yours.pixels().len() <= MOST) {
        _ if is_size => Some(ours.picture.clone()),
        Some(step) => Some(step.picture(&camera(yours.width(), yours.height()), 1)),
        None => None,
    };
    let other = locked.iter().find(|one| one.picture == *yours);
    let mut text = match other {
        Some(other) => another(yours, ours, other, step),
        None => told(yours, ours, drawn.as_ref(), step),
    };
    if let Some(drawn) = &drawn {
        text += &pixel(yours, drawn, step.filter(|_| is_size));
    }
    let difference = drawn.map(|drawn| panels(yours, &drawn));
    Answer { code: 1, text: text.trim_end().to_owned(), difference }
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
    if known(sum(yours)).iter().any(|(_, of)| of == asked) {
        return start + &listed(yours, asked).unwrap_or_default();
    }
    // Where no ray meets an object, every step draws that of the first.
    match step.filter(|_| name == Step::Rays.name()) {
        Some(step) => start + &stages(step, yours, &ours.picture),
        None => start,
    }
}

/// What went wrong. `drawn` is ours at the size of yours.
fn told(
    yours: &RgbImage,
    ours: &Locked,
    drawn: Option<&RgbImage>,
    step: Option<Step>,
) -> String {
    let name = &ours.name;
    let listed = listed(yours, name);
    if let Some(whole) = whole(yours, ours) {
        let back = whole.place.map_or(String::new(), |place| back(&[place]));
        let listed = listed.unwrap_or(back);
        return format!("Not right: your picture is {}.\n{listed}", whole.text);
    }
    if let Some(listed) = listed {
        return listed;
    }
    let start = format!("Not right yet, compared with {name}.\n");
    let ((w, h), (columns, rows)) = (yours.dimensions(), ours.picture.dimensions());
    if (w, h) != (columns, rows) {
        let is_small = yours.pixels().len() <= MOST;
        if is_small && let Some(part) = part(yours, &ours.picture, drawn) {
            return format!("Not right: your picture is that of {name}, {part}.\n");
        }
        return format!(
            "{start}It is {w}×{h} pixels, and ours {columns}×{rows}: draw it with the \
             default options, and more can be told.\n"
        );
    }
    let Some(step) = step else { return start };
    match number(step, yours, &ours.picture) {
        Some(found) => {
            let back = found.place.map_or(String::new(), |place| back(&[place]));
            format!("Not right: {}{back}", found.text)
        }
        None => start + &stages(step, yours, &ours.picture),
    }
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
    let wrong: Vec<_> = pairs.filter(|((.., a), b)| far(a, b)).collect();
    let ((i, j, yours_there), ours_there) = wrong[wrong.len() / 2];
    let computed = step.map_or(String::new(), |step| {
        let ray = camera(yours.width(), yours.height()).ray(i.into(), j.into());
        format!(": {}", computed(step, &ray))
    });
    let [a, b] = [yours_there, ours_there].map(|pixel| {
        let [r, g, b] = pixel.0;
        format!("({r}, {g}, {b})")
    });
    format!(
        "{count} of {} pixels differ, by up to {largest} of 255.\n\
         Column {i}, row {j}: yours is {a}, ours {b}{computed}.\n",
        yours.pixels().len(),
    )
}
