use crate::answer::Cause;
use crate::comparison::Comparison;
use crate::scene_mistake::colour_with_mistake;
use crate::target::Target;
use course::{Mistake, find_mistakes_with_hash, hash_picture, mistakes};
use image::RgbImage;
use step01_rays::rgb8;

/// The most lines of a diff that is told.
const LINES: usize = 4;

/// The listed mistakes that give a picture: those drawn for the target, or else for a picture
/// of another name.
pub(crate) fn find_listed_mistakes(
    yours: &RgbImage,
    target: &Target,
    comparison: Option<&Comparison>,
) -> Vec<Cause> {
    if let Some(expected) = &target.name {
        let mut all = find_mistakes_with_hash(hash_picture(yours));
        if all.iter().any(|(_, name)| name == expected) {
            all.retain(|(_, name)| name == expected);
        }
        // Of those that give it for several other names, the first is enough.
        all.dedup_by(|(one, _), (other, _)| one.title == other.title);
        let drawn_for = |name: &str| match name == expected {
            true => String::new(),
            false => format!(", drawn for {name}"),
        };
        return all.iter().map(|(mistake, name)| cause(mistake, &drawn_for(name))).collect();
    }
    let Some((comparison, drawing)) = comparison.zip(target.drawing.as_ref()) else {
        return vec![];
    };
    let gives_all = |mistake: &Mistake| {
        let colour = |ray| colour_with_mistake(mistake.title, &drawing.own.scene, ray);
        comparison.pixels().all(|pixel| rgb8(colour(&pixel.ray)).0 == pixel.yours)
    };
    let all = mistakes().into_iter().filter(gives_all);
    all.map(|mistake| cause(&mistake, "")).collect()
}

/// A listed mistake as a cause: its diff, if it is short, and, if the book shows it, why it is
/// wrong, and where.
fn cause(mistake: &Mistake, drawn_for: &str) -> Cause {
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
    let words = format!("{}{drawn_for}", mistake.title);
    Cause { words, step: Some(step), file: Some(mistake.file.clone()), details: lines.concat() }
}
