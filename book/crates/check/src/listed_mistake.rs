use crate::answer::Cause;
use crate::comparison::{Comparison, Pixel};
use crate::drawing::bytes;
use crate::scene_mistake::{colour_with_mistake, scene_mistakes};
use crate::target::Target;
use course::{Mistake, Step, find_mistakes_with_hash, hash_picture};
use image::RgbImage;
use std::collections::BTreeMap;

/// The most lines of a diff that is told.
const LINES: usize = 4;

/// The heading in the book for each file of the steps, such as `step01_rays/rgb8.rs`.
pub fn sections() -> impl Iterator<Item = (&'static str, &'static str)> {
    include_str!("../sections.txt").lines().filter_map(|line| line.split_once(" | "))
}

/// The listed mistakes that give a picture, and the name of the locked picture that they were
/// drawn for where it isn't the target.
pub(crate) fn find_listed_mistakes(
    yours: &RgbImage,
    target: &Target,
    comparison: Option<&Comparison>,
) -> (Vec<Mistake>, Option<&'static str>) {
    if let Some(expected) = &target.name {
        let mut all = find_mistakes_with_hash(hash_picture(yours));
        if all.iter().any(|(_, name)| name == expected) {
            all.retain(|(_, name)| name == expected);
        }
        let drawn_for = all.first().map(|(_, name)| *name).filter(|name| name != expected);
        return (all.into_iter().map(|(mistake, _)| mistake).collect(), drawn_for);
    }
    let Some((comparison, drawing)) = comparison.zip(target.drawing.as_ref()) else {
        return (vec![], None);
    };
    let gives_pixel = |mistake: &Mistake, pixel: &Pixel| {
        bytes(colour_with_mistake(mistake.title, &drawing.scene, &pixel.ray)) == pixel.yours
    };
    let all = scene_mistakes()
        .filter(|mistake| comparison.pixels.iter().all(|pixel| gives_pixel(mistake, pixel)));
    (all.collect(), None)
}

/// Tells the listed mistakes that give a picture, drawn for one of another name or for its
/// own, and the cause, as far as they have it in common.
pub(crate) fn tell_listed_mistakes(
    mistakes: &[Mistake],
    drawn_for: Option<&str>,
) -> Option<(String, Cause)> {
    let first = mistakes.first()?;
    let mut files: BTreeMap<&str, usize> = BTreeMap::new();
    mistakes.iter().for_each(|mistake| *files.entry(&mistake.file).or_default() += 1);
    let start = match mistakes.len() {
        1 => format!("This mistake gives this very picture: {}.", first.title),
        count => {
            let files = files.iter().map(|(file, count)| {
                let name = file.rsplit('/').next().unwrap_or_default();
                let step = Step::from_path(file).map_or(0, Step::number);
                format!("{count} in {name} of step {step}")
            });
            format!(
                "{count} mistakes that we know give this very picture: {}.\nOne is: {}.",
                files.collect::<Vec<_>>().join(", "),
                first.title
            )
        }
    };
    let start = drawn_for.map(|name| format!("Drawn for {name}: ")).unwrap_or_default() + &start;
    let reason = match &first.book_entry {
        Some(shown) if mistakes.len() == 1 => format!("{}\n", shown.reason),
        _ => String::new(),
    };
    let is_one_file = files.len() == 1;
    let text = format!("{start}\n{}{reason}{}", format_short_diff(first), format_place(first));
    let cause = Cause {
        step: first.step().filter(|step| mistakes.iter().all(|one| one.step() == Some(*step))),
        file: is_one_file.then(|| first.file.clone()),
        mistake: (mistakes.len() == 1).then(|| first.title.to_owned()),
        all: mistakes.iter().map(|one| format!("{} ({})", one.title, one.file)).collect(),
    };
    Some((text, cause))
}

/// Formats its diff, indented, cut where it is long.
fn format_short_diff(mistake: &Mistake) -> String {
    let diff = mistake.old_and_new_lines();
    let lines: Vec<_> = diff.lines().map(|line| format!("  {line}\n")).collect();
    match lines.len() {
        0..=LINES => lines.concat(),
        _ => lines[..LINES - 1].concat() + "  …\n",
    }
}

/// The file of a mistake, and its section in the book.
fn format_place(mistake: &Mistake) -> String {
    let file = mistake.file.replace("steps/", "").replace("/src/", "/");
    let section_of_file = sections().find(|(name, _)| *name == file).map(|(_, section)| section);
    let section = mistake.book_entry.as_ref().map(|shown| shown.section).or(section_of_file);
    let chapter = section.zip(mistake.step());
    let chapter = chapter.map(|(title, step)| format!("step {}, \"{title}\"", step.number()));
    format!("See {}{}.\n", chapter.map_or(String::new(), |text| text + ", and "), mistake.file)
}
