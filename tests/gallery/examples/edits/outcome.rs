use crate::edit::Edit;
use gallery::{Answer, Mistake, Parts, Step, camera, check, mistakes};
use image::RgbImage;
use std::{error::Error, path::Path};

/// What becomes of a reader who asks `check`.
pub struct Outcome {
    /// `named`, `nearly`, `told`, `stage`, `nothing` or `WRONG`.
    pub kind: &'static str,
    /// What was told.
    pub why: String,
    /// The whole answer.
    pub text: String,
}

/// Asks `check` for one picture and judges what it says.
pub fn judged(
    edit: &Edit,
    step: Step,
    path: &Path,
) -> Result<Outcome, Box<dyn Error>> {
    let Answer { code, text, .. } = check(path, Some(step.name()));
    let yours = image::open(path)?.to_rgb8();
    let (kind, why) = match code {
        1 => verdict(edit, &yours, step, &text),
        _ => ("WRONG", format!("exit code {code}")),
    };
    Ok(Outcome { kind, why, text })
}

fn verdict(
    edit: &Edit,
    yours: &RgbImage,
    step: Step,
    text: &str,
) -> (&'static str, String) {
    let mut names = vec![];
    let mut kind = "named";
    for line in text.lines().filter(|line| is_name(line)) {
        let causes = causes(line);
        let name: Vec<_> = causes.iter().map(|cause| cause.name).collect();
        let name = name.join(" + ");
        let (left, told) =
            (unexplained(yours, step, &causes, text), left_over(line));
        if left != told {
            return ("WRONG", format!("{name}: {left} pixels, not {told}"));
        }
        if 0 < left {
            kind = "nearly";
        }
        names.push(name);
    }
    let is_told = |word: &&String| text.contains(word.as_str());
    match names.is_empty() {
        false => (kind, names.join(" = ")),
        true => match edit
            .faults
            .iter()
            .all(|fault| fault.words.iter().any(|word| is_told(&word)))
        {
            true => ("told", text.lines().next().unwrap_or_default().to_owned()),
            false => {
                ("nothing", text.lines().next().unwrap_or_default().to_owned())
            }
        },
    }
}

fn is_name(line: &str) -> bool {
    line.contains("what you get when") || line.contains("same picture when")
}

/// The mistakes that a line names.
fn causes(line: &str) -> Vec<&'static Mistake> {
    let all: Vec<_> = mistakes().filter(|one| line.contains(one.when)).collect();
    let is_part = |one: &&Mistake| {
        all.iter()
            .any(|other| other.when != one.when && other.when.contains(one.when))
    };
    all.iter().copied().filter(|one| !is_part(one)).collect()
}

/// How many pixels a line says that its mistakes do not explain.
fn left_over(line: &str) -> usize {
    let words = line.split_once(" in all but ").map(|(_, rest)| rest);
    let number = words.and_then(|words| words.split(' ').next());
    number.and_then(|number| number.parse().ok()).unwrap_or(0)
}

/// How many pixels they do not explain.
fn unexplained(
    yours: &RgbImage,
    step: Step,
    causes: &[&Mistake],
    text: &str,
) -> usize {
    let (width, height) = yours.dimensions();
    let mut parts = Parts::right(&camera(width, height));
    causes.iter().for_each(|cause| (cause.change)(&mut parts));
    let samples = text
        .split_once(" rays a pixel")
        .and_then(|(before, _)| before.rsplit_once('×')?.1.parse().ok());
    let ours = parts.picture(step, samples.unwrap_or(1));
    ours.pixels().zip(yours.pixels()).filter(|(ours, yours)| ours != yours).count()
}
