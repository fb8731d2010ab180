use crate::recognise::scattered;
use crate::{Cause, Difference, Found, Mistake, Step};
use crate::{locked, mistakes, names, png, recognise, sight};
use image::{RgbImage, imageops};
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

/// What `check` says, and its exit code.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// 0 if the picture is right, 1 if it is not, 2 if there is nothing to compare.
    pub code: u8,
    /// One sentence or several lines.
    pub text: String,
}

/// A picture to compare with, and its name.
type Named = (&'static str, RgbImage);

/// All pictures that there are to compare with, or why one of them can't be had.
static LOCKED: LazyLock<Result<Vec<Named>, String>> = LazyLock::new(|| {
    names().into_iter().map(|name| Ok((name, locked(name)?))).collect()
});

/// Compares the picture in `file` with the locked picture `name`, or with the nearest
/// where `name` is left out.
///
/// Where they differ, a picture of both and the difference goes into `folder`.
pub fn check(file: &Path, name: Option<&str>, folder: &Path) -> Answer {
    let answer = || {
        let known = names();
        if let Some(name) = name.filter(|name| !known.contains(name)) {
            let known = known.join(", ");
            return Err(format!(
                "there is no picture '{name}'; allowed are {known}"
            ));
        }
        let yours = png::read(file)?;
        compared(&yours, name, LOCKED.as_deref()?, folder)
    };
    answer().unwrap_or_else(|sentence| Answer {
        code: 2,
        text: format!("error: {sentence}"),
    })
}

fn compared(
    yours: &RgbImage,
    name: Option<&str>,
    locked: &[Named],
    folder: &Path,
) -> Result<Answer, String> {
    let same =
        || locked.iter().filter(|(_, ours)| ours == yours).map(|(name, _)| *name);
    if let Some(same) = same().find(|same| name.is_none_or(|name| name == *same)) {
        let text = format!("Right: this is the picture of {same}, in every pixel.");
        return Ok(Answer { code: 0, text });
    }
    let asked = |step: &Step| name.is_none_or(|name| name == step.name());
    let steps: Vec<_> = Step::ALL.into_iter().filter(asked).collect();
    // What is right elsewhere is not nearly something else here.
    let is_clear = |found: &Found| found.rest == 0 || same().next().is_none();
    let found = recognise(yours, &steps).filter(is_clear);
    let known = name.or_else(|| Some(found.as_ref()?.causes[0].step.name()));
    let (name, ours) = locked
        .iter()
        .filter(|(name, _)| known.is_none_or(|known| known == *name))
        .min_by_key(|(_, ours)| distance(yours, ours))
        .ok_or("there is no locked picture to compare with")?;
    let found = found.map_or_else(|| turned(yours, ours), Guess::from);

    let mut text = match same().next() {
        Some(same) => format!(
            "Not right yet: this is the picture of {same}, not of {name}.\n"
        ),
        None => String::new(),
    };
    if text.is_empty() || !found.causes.is_empty() {
        text += &verdict(&found, name);
    }
    text += &options(yours, ours, &found);
    text += &differences(yours, (name, ours), &found, folder);
    Ok(Answer { code: 1, text: text.trim_end().to_owned() })
}

/// What is known of a picture, whether it is of a step or of an exercise.
struct Guess {
    /// What went wrong; several lists where several give the same picture; none where
    /// nothing is known.
    causes: Vec<Vec<&'static Mistake>>,
    /// How many pixels are left unexplained.
    rest: usize,
    /// The side of the grid of rays in each pixel.
    samples: u32,
}

impl From<Found> for Guess {
    fn from(found: Found) -> Self {
        let (samples, rest) = (found.causes[0].samples, found.rest);
        let causes = found.causes.into_iter().map(|cause| cause.mistakes);
        Self { causes: causes.collect(), rest, samples }
    }
}

impl Guess {
    /// Whether nothing but the size or the samples is wrong.
    fn is_right(&self) -> bool {
        self.causes.first().is_some_and(Vec::is_empty)
    }
}

/// The mistakes that can be told from a picture alone: those of an exercise too.
fn turned(yours: &RgbImage, ours: &RgbImage) -> Guess {
    let ways: [(&str, Way); 3] = [
        ("y-down", |ours| imageops::flip_vertical(ours)),
        ("mirrored", |ours| imageops::flip_horizontal(ours)),
        ("bgr", |ours| {
            let mut swapped = ours.clone();
            swapped.pixels_mut().for_each(|pixel| pixel.0.reverse());
            swapped
        }),
    ];
    let choices: [&[usize]; 6] = [&[0], &[1], &[2], &[0, 1], &[0, 2], &[1, 2]];
    let explains = |choice: &&&[usize]| {
        choice.iter().fold(ours.clone(), |ours, &way| ways[way].1(&ours)) == *yours
    };
    let named = |choice: &&[usize]| {
        let chosen =
            |one: &&Mistake| choice.iter().any(|&way| ways[way].0 == one.name);
        mistakes().filter(chosen).collect()
    };
    let causes = choices.iter().find(explains).into_iter().map(named).collect();
    Guess { causes, rest: 0, samples: 1 }
}

/// What a mistake makes of any right picture.
type Way = fn(&RgbImage) -> RgbImage;

/// Says what went wrong, as far as it is known, and where to go back to.
fn verdict(guess: &Guess, name: &str) -> String {
    let rest = match guess.rest {
        0 => String::new(),
        1 => " in all but 1 pixel".to_owned(),
        rest => format!(" in all but {rest} pixels"),
    };
    let Some((first, others)) = guess.causes.split_first() else {
        return format!(
            "Not right yet: this is not the picture of {name}, and no known mistake \
             gives it.\n"
        );
    };
    if first.is_empty() {
        return match guess.rest {
            0 if guess.samples == 1 => {
                format!("Right but for its size: this is the picture of {name}.\n")
            }
            0 => {
                format!("Right but for its rays: this is the picture of {name}.\n")
            }
            _ => format!("Nearly right: this is the picture of {name}{rest}.\n"),
        };
    }
    let when = |mistakes: &[&Mistake]| {
        let all: Vec<_> = mistakes.iter().map(|mistake| mistake.when).collect();
        all.join(", and ")
    };
    let mut text = format!(
        "Not right yet: your picture of {name} is{rest} what you get when {}.\n",
        when(first)
    );
    for mistake in first {
        text += &back(mistake);
    }
    for other in others.iter().take(2) {
        let _ = writeln!(text, "You get the same picture when {}.", when(other));
        let is_told =
            |one: &&&Mistake| first.iter().any(|told| told.name == one.name);
        other.iter().filter(|one| !is_told(one)).for_each(|one| text += &back(one));
    }
    text
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
fn options(yours: &RgbImage, ours: &RgbImage, guess: &Guess) -> String {
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
    if guess.samples != 1 {
        let _ = writeln!(
            text,
            "It has {0}×{0} rays a pixel, and the locked picture 1: --samples 1 gives that.",
            guess.samples
        );
    }
    text
}

/// Says how the pictures differ, and writes both and the difference side by side.
///
/// Where the size is another, a step's own picture is drawn anew at that size.
fn differences(
    yours: &RgbImage,
    (name, ours): (&str, &RgbImage),
    guess: &Guess,
    folder: &Path,
) -> String {
    if guess.is_right() && guess.rest == 0 {
        return String::new();
    }
    let step = Step::named(name);
    let ours = match step {
        Some(step)
            if yours.dimensions() != ours.dimensions() && 2 <= yours.width() =>
        {
            &anew(yours, step, guess.samples)
        }
        _ => ours,
    };
    if yours.dimensions() != ours.dimensions() {
        return String::new();
    }
    let mut text = match guess.causes[..] {
        [] => sight::seen(yours, ours, step),
        _ => sight::region(yours, ours),
    };
    if guess.is_right() && text.contains("by up to 1 of 255") {
        text += "That is rounding, as of numbers with fewer digits than f64.\n";
    }
    let path = folder.join(format!("{name}.png"));
    let saved = fs::create_dir_all(folder)
        .map_err(Into::into)
        .and_then(|()| Difference::picture(yours, ours).save(&path));
    let path = path.display();
    text += &match saved {
        Ok(()) => format!("Yours, ours and the difference side by side: {path}\n"),
        Err(error) => format!("{path} can't be written: {error}\n"),
    };
    text
}

/// The right picture of `step` in the size of yours.
fn anew(yours: &RgbImage, step: Step, samples: u32) -> RgbImage {
    let rays = yours.pixels().len() * samples.pow(2) as usize;
    // More rays a pixel than that are not worth the wait.
    let samples = if rays < 4_000_000 { samples } else { 1 };
    let cause = Cause { step, samples, mistakes: vec![] };
    cause.parts(yours.dimensions()).picture(step, samples)
}

/// How far apart two pictures of any sizes are, at places all over them; one may be
/// a mirror image.
fn distance(yours: &RgbImage, ours: &RgbImage) -> Option<u64> {
    let places: Vec<_> =
        scattered(yours, 2000).into_iter().zip(scattered(ours, 2000)).collect();
    let (right, bottom) = (ours.width() - 1, ours.height() - 1);
    let apart = |(is_left, is_up): (bool, bool)| {
        let channels = places.iter().flat_map(|&((i, j), (k, l))| {
            let (k, l) = (
                if is_left { right - k } else { k },
                if is_up { bottom - l } else { l },
            );
            yours.get_pixel(i, j).0.into_iter().zip(ours.get_pixel(k, l).0)
        });
        channels.map(|(a, b)| u64::from(a.abs_diff(b))).sum()
    };
    let ways = [(false, false), (false, true), (true, false), (true, true)];
    ways.into_iter().map(apart).min()
}
