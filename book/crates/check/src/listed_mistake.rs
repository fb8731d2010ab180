use crate::answer::Cause;
use crate::comparison::Comparison;
use crate::scene_mistake::colour_with_mistake;
use crate::target::Target;
use course::{Mistake, find_mistakes_with_hash, hash_picture, mistakes};
use image::RgbImage;
use step01_rays::rgb8;

/// The most lines of a diff that is told.
const LINES: usize = 4;

/// The listed mistakes that give a picture: by its hash, and with the scene of a name as far as
/// they are drawn anew.
pub(crate) fn find_listed_mistakes(
    yours: &RgbImage,
    target: &Target,
    comparison: Option<&Comparison>,
) -> Vec<Cause> {
    let mut all: Vec<_> = find_mistakes_with_hash(hash_picture(yours))
        .into_iter()
        .filter(|(_, name)| target.name.as_deref() == Some(name))
        .map(|(mistake, _)| mistake)
        .collect();
    if let (None, Some(comparison), Some(drawing)) = (&target.name, comparison, &target.drawing) {
        all.extend(mistakes().into_iter().filter(|mistake| {
            let colour = |ray| colour_with_mistake(mistake.title, &drawing.own.scene, ray);
            comparison.pixels().all(|pixel| rgb8(colour(&pixel.ray)).0 == pixel.yours)
        }));
    }
    all.iter().map(cause).collect()
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
