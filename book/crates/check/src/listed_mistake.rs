use crate::answer::Cause;
use crate::target::hash_if_small;
use course::{Mistake, find_mistakes_with_hash};
use image::RgbImage;

/// The most lines of a diff that an answer shows.
const LINES: usize = 4;

/// The listed mistakes that give the picture of this name as it is in every pixel.
pub(crate) fn find_listed_mistakes(yours: &RgbImage, name: &str) -> Vec<Cause> {
    let all = hash_if_small(yours).map(find_mistakes_with_hash).unwrap_or_default();
    let all = all.into_iter();
    all.filter(|(_, drawn)| *drawn == name).map(|(mistake, _)| cause(&mistake)).collect()
}

/// A listed mistake as a cause: its diff, if it is short, and, if the book shows it, why it is
/// wrong, and where.
fn cause(mistake: &Mistake) -> Cause {
    let diff = mistake.old_and_new_lines();
    let mut lines: Vec<_> = diff.lines().map(|line| format!("  {line}\n")).collect();
    if LINES < lines.len() {
        lines.clear();
    }
    let step = mistake.step;
    let Mistake { reason, section, .. } = mistake;
    if !reason.is_empty() {
        lines.push(format!("{reason}\nSee step {}, \"{section}\".\n", step.number()));
    }
    let words = mistake.title.to_owned();
    Cause { words, step: Some(step), file: Some(mistake.file.clone()), details: lines.concat() }
}
