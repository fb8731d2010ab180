use crate::difference::apart;
use crate::recognise::{RAYS, ROUNDING, Rest, flat, scattered};
use crate::{Difference, Found, Mistake, Step};
use crate::{camera, locked, mistakes, names, png, recognise, sight, workspace};
use image::RgbImage;
use std::borrow::Cow;
use std::fmt::Write;
use std::path::Path;
use std::sync::LazyLock;

/// What `check` says, and its exit code.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// 0 if the picture is right, 1 if it is not, 2 if there is nothing to compare.
    pub code: u8,
    /// One sentence or several lines.
    pub text: String,
    /// The reader's picture, ours and the difference side by side, where they differ.
    pub difference: Option<RgbImage>,
}

impl Answer {
    /// An answer of words alone.
    pub fn new(code: u8, text: String) -> Self {
        Self { code, text, difference: None }
    }
}

/// A picture to compare with, and its name.
type Named = (String, RgbImage);

/// All pictures that there are to compare with, or why one of them can't be had.
static LOCKED: LazyLock<Result<Vec<Named>, String>> = LazyLock::new(|| {
    let all = names().into_iter().map(|name| Ok((name.clone(), locked(&name)?)));
    all.collect()
});

/// The steps whose code in this folder does not draw their locked pictures.
static BROKEN: LazyLock<Vec<Step>> = LazyLock::new(|| {
    let is_broken = |step: &Step| {
        let drawn = step.picture(&camera(640, 360), 1);
        locked(step.name()).is_ok_and(|ours| ours != drawn)
    };
    Step::ALL.into_iter().filter(is_broken).collect()
});

/// Compares the picture in `file` with the locked picture `name`, or with the nearest
/// where `name` is left out.
pub fn check(file: &Path, name: Option<&str>) -> Answer {
    png::read(file).map_or_else(refused, |picture| look(&picture, name))
}

/// Compares a picture with the locked picture `name`, or with the nearest where `name`
/// is left out.
pub fn look(yours: &RgbImage, name: Option<&str>) -> Answer {
    let known = names();
    let is_known = |name: &&str| known.iter().any(|known| known == name);
    if known.is_empty() || name.is_some_and(|name| !is_known(&name)) {
        return refused(format!(
            "there is no locked picture {}in {}; allowed are {}",
            name.map(|name| format!("'{name}' ")).unwrap_or_default(),
            workspace().display(),
            known.join(", ")
        ));
    }
    let locked = LOCKED.as_deref().map_err(Clone::clone);
    locked.and_then(|locked| compared(yours, name, locked)).unwrap_or_else(refused)
}

/// Why there is nothing to compare.
fn refused(sentence: String) -> Answer {
    Answer::new(2, format!("error: {sentence}"))
}

fn compared(
    yours: &RgbImage,
    name: Option<&str>,
    locked: &[Named],
) -> Result<Answer, String> {
    let is_asked = |other: &str| name.is_none_or(|name| name == other);
    let asked = || locked.iter().filter(|(name, _)| is_asked(name));
    if let Some((same, _)) = asked().find(|(_, ours)| ours == yours) {
        let text = format!("Right: this is the picture of {same}, in every pixel.");
        return Ok(Answer::new(0, text));
    }
    let same = locked.iter().find(|(_, ours)| ours == yours);
    let steps = Step::ALL.into_iter().filter(|step| is_asked(step.name()));
    let (broken, steps): (Vec<_>, Vec<_>) =
        steps.partition(|step| BROKEN.contains(step));
    // What is right elsewhere is not nearly something else here.
    let is_clear = |found: &Found| found.rest.is_none() || same.is_none();
    let found = recognise(yours, &steps)
        .or_else(|| asked().find_map(|ours| turned(yours, ours)))
        .filter(is_clear);
    let is_found =
        |name: &str| found.as_ref().is_none_or(|found| found.name == name);
    let (name, ours) = asked()
        .filter(|(name, _)| is_found(name))
        .min_by_key(|(_, ours)| distance(yours, ours))
        .ok_or("there is no locked picture to compare with")?;

    let mut text = told_of(&broken);
    let step = Step::named(name).filter(|step| !broken.contains(step));
    if let Some((same, _)) = same {
        let _ = writeln!(
            text,
            "Not right yet: this is the picture of {same}, not of {name}."
        );
    }
    match &found {
        Some(found) => text += &verdict(found, name),
        None if same.is_some() => {}
        None => {
            let _ =
                write!(text, "Not right yet: this is not the picture of {name}");
            text += match flat(yours).is_some() || !broken.is_empty() {
                true => ".\n",
                false => ", and no known mistake gives it.\n",
            };
        }
    }
    if let Some(colour) = flat(yours) {
        let all = match yours.pixels().all(|pixel| *pixel == colour) {
            true => "",
            false => " in nearly all pixels",
        };
        let _ = writeln!(text, "It has one colour only{all}: {:?}.", colour.0);
    }
    text += &options(yours, ours, found.as_ref());
    let ours = ours_at(yours.dimensions(), ours, step, found.as_ref());
    text += &ours.as_ref().map_or(String::new(), |ours| {
        differences(yours, ours, step, found.as_ref())
    });
    let difference = ours.map(|ours| Difference::picture(yours, &ours));
    Ok(Answer { code: 1, text: text.trim_end().to_owned(), difference })
}

/// Says that our own code is wrong, where it is.
fn told_of(broken: &[Step]) -> String {
    if broken.is_empty() {
        return String::new();
    }
    let names: Vec<_> = broken.iter().map(|step| step.name()).collect();
    format!(
        "The code in {} does not draw the locked picture of {} any more. Mend it first; \
         until then, few mistakes can be told.\n",
        workspace().display(),
        names.join(", ")
    )
}

/// The mistakes that can be told from two pictures alone: those of an exercise too.
fn turned(yours: &RgbImage, (name, ours): &Named) -> Option<Found> {
    let (width, height) = ours.dimensions();
    if yours.dimensions() != (width, height) {
        return None;
    }
    let rest = |[is_down, is_left, is_swapped]: [bool; 3]| {
        let apart = yours.enumerate_pixels().map(|(i, j, yours)| {
            let i = if is_left { width - 1 - i } else { i };
            let j = if is_down { height - 1 - j } else { j };
            let mut ours = *ours.get_pixel(i, j);
            if is_swapped {
                ours.0.reverse();
            }
            apart(yours, &ours)
        });
        Rest { apart: apart.collect(), all: yours.pixels().len() }
    };
    let choices = (0..8).map(|bits| [1, 2, 4].map(|bit| bits & bit != 0));
    let rests = choices.map(|choice| (choice, rest(choice)));
    let (choice, rest) = rests.min_by_key(|(_, rest)| rest.beyond(ROUNDING))?;
    let chosen = |one: &&Mistake| {
        let mut names = ["y-down", "mirrored", "bgr"].iter().zip(choice);
        names.any(|(name, is_chosen)| is_chosen && *name == one.name)
    };
    let causes = vec![mistakes().filter(chosen).collect()];
    let name = name.clone();
    rest.is_few(ROUNDING).then_some(Found { name, samples: 1, causes, rest })
}

/// Says what went wrong, as far as it is known, and where to go back to.
fn verdict(found: &Found, name: &str) -> String {
    let (first, others) = (&found.causes[0], &found.causes[1..]);
    let rest = rest(&found.rest);
    if first.is_empty() {
        let but = match (found.rest.is_none(), found.samples) {
            (false, _) => "Nearly right",
            (true, 1) => "Right but for its size",
            (true, _) => "Right but for its rays",
        };
        return format!("{but}: this is the picture of {name}{rest}.\n");
    }
    let when = |mistakes: &[&Mistake]| {
        let all: Vec<_> = mistakes.iter().map(|mistake| mistake.when).collect();
        all.join(", and ")
    };
    let mut text = format!(
        "Not right yet: your picture of {name} is{rest} what you get when {}.\n",
        when(first)
    );
    first.iter().for_each(|mistake| text += &back(mistake));
    for other in others {
        let pages: Vec<_> = other.iter().map(|one| one.section.page()).collect();
        let (when, pages) = (when(other), pages.join(", "));
        let _ = writeln!(text, "You get the same picture when {when} ({pages}).");
    }
    text
}

/// The pixels that the known causes do not explain, or that were not compared.
fn rest(rest: &Rest) -> String {
    let by = match rest.apart.iter().max() {
        Some(by @ 1..=ROUNDING) => format!(" (off by {by} of 255 at most)"),
        _ => String::new(),
    };
    let compared = match rest.apart.len() {
        all if all == rest.all => String::new(),
        some => format!(" of the {some} that were compared"),
    };
    match rest.beyond(0) {
        0 if compared.is_empty() => String::new(),
        0 => format!(" in all pixels{compared}"),
        1 => format!(" in all but 1 pixel{compared}{by}"),
        pixels => format!(" in all but {pixels} pixels{compared}{by}"),
    }
}

/// Where to go back to, to find one mistake.
fn back(mistake: &Mistake) -> String {
    let Mistake { says, section, .. } = mistake;
    format!(
        "  {says}\n  Go back to step {}, \"{}\" ({}), and compare with {}.\n",
        section.step.number(),
        section.heading,
        section.page(),
        section.path(),
    )
}

/// Says both sizes and both numbers of rays where they differ, and the options that
/// give the right ones.
fn options(yours: &RgbImage, ours: &RgbImage, found: Option<&Found>) -> String {
    let ((w, h), (right_w, right_h)) = (yours.dimensions(), ours.dimensions());
    let mut text = String::new();
    if (w, h) != (right_w, right_h) {
        let is_shape = (u64::from(w) * u64::from(right_h))
            .abs_diff(u64::from(h) * u64::from(right_w))
            <= u64::from(right_w);
        let width = (w != right_w).then(|| format!("--width {right_w}"));
        let divisor = (1..=right_h).rev().find(|n| right_w % n + right_h % n == 0);
        let (x, y) =
            divisor.map_or((right_w, right_h), |n| (right_w / n, right_h / n));
        let aspect =
            (!is_shape || w == right_w).then(|| format!("--aspect {x}:{y}"));
        let options: Vec<_> = width.into_iter().chain(aspect).collect();
        let _ = writeln!(
            text,
            "It is {w}×{h} pixels, and the locked picture {right_w}×{right_h}: {} \
             gives that size.",
            options.join(" ")
        );
    }
    if let Some(Found { samples: samples @ 2.., .. }) = found {
        let _ = writeln!(
            text,
            "It has {samples}×{samples} rays a pixel, and the locked picture 1: \
             --samples 1 gives that."
        );
    }
    text
}

/// Our picture at the size of the reader's, where there is anything to show: a step's
/// own is drawn anew at another size.
fn ours_at<'a>(
    (width, height): (u32, u32),
    ours: &'a RgbImage,
    step: Option<Step>,
    found: Option<&Found>,
) -> Option<Cow<'a, RgbImage>> {
    if found.is_some_and(|found| is_right(found) && found.rest.is_none()) {
        return None;
    }
    if ours.dimensions() == (width, height) {
        return Some(Cow::Borrowed(ours));
    }
    // More rays a pixel are not worth the wait, except for a small picture.
    let samples = found.map_or(1, |found| found.samples);
    let is_small = u64::from(width * height) * 256 <= RAYS;
    let samples = if is_small { samples } else { 1 };
    let step = step.filter(|_| 2 <= width)?;
    Some(Cow::Owned(step.picture(&camera(width, height), samples)))
}

/// Whether nothing is wrong with the picture but its size, its rays, or single pixels.
fn is_right(found: &Found) -> bool {
    found.causes[0].is_empty()
}

/// Says how two pictures of one size differ.
fn differences(
    yours: &RgbImage,
    ours: &RgbImage,
    step: Option<Step>,
    found: Option<&Found>,
) -> String {
    let mut text = match found {
        None => sight::seen(yours, ours, step),
        _ => sight::region(yours, ours),
    };
    if found.is_some_and(is_right) && text.contains("by up to 1 of 255") {
        text += "That is rounding, as of numbers with fewer digits than f64.\n";
    }
    text
}

/// How far apart two pictures of any sizes are, at places all over them.
fn distance(yours: &RgbImage, ours: &RgbImage) -> u64 {
    let places = scattered(yours, 2000).into_iter().zip(scattered(ours, 2000));
    let apart = places.map(|((i, j), (k, l))| {
        let pairs = yours.get_pixel(i, j).0.into_iter().zip(ours.get_pixel(k, l).0);
        pairs.map(|(a, b)| u64::from(a.abs_diff(b))).sum::<u64>()
    });
    apart.sum()
}
