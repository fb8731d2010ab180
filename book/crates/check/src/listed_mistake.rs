use crate::source_ref::{SourceRef, go_back_sentences, test_command_sentence};
use course::{Mistake, Step};
use course::{find_mistakes_with_hash, hash_picture};
use image::RgbImage;
use std::collections::BTreeMap;

/// The most lines of a diff that is told.
const LINES: usize = 4;

/// The most mistakes that are told with their titles.
const TITLES: usize = 3;

/// Tells which mistakes of the list give these very pixels.
pub(crate) fn explain_listed_mistake(yours: &RgbImage, expected_name: &str) -> Option<String> {
    let mut all = find_mistakes_with_hash(hash_picture(yours));
    if all.iter().any(|(_, name)| name == expected_name) {
        all.retain(|(_, name)| name == expected_name);
    }
    let (first, name) = all.first()?;
    let start = match name == expected_name {
        true => String::new(),
        false => format!(
            "These are the pixels of {name} with a mistake in it, not of {expected_name}.\n"
        ),
    };
    let mut files: BTreeMap<&str, usize> = BTreeMap::new();
    all.iter().for_each(|(mistake, _)| *files.entry(&mistake.file).or_default() += 1);
    if 1 < files.len() {
        return Some(start + &explain_several_files(all.len(), first, files));
    }
    let explanation = match &first.book_entry {
        Some(shown) if all.len() == 1 => format!("{}\n", shown.reason),
        _ => String::new(),
    };
    let titles: Vec<_> = all.iter().take(TITLES).map(|(mistake, _)| mistake.title).collect();
    let give = match all.len() {
        1 => "this mistake gives".to_owned(),
        count => format!("{count} mistakes in one file give, such as"),
    };
    Some(format!(
        "{start}Your picture is, in every pixel, what {give}: {}.\n{}{explanation}{}",
        titles.join("; "),
        format_short_diff(first),
        go_back_to_mistake_sentences(first),
    ))
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

fn go_back_to_mistake_sentences(mistake: &Mistake) -> String {
    let Some(mut place) = SourceRef::from_path(&mistake.file) else {
        return format!("Compare with {}.\n", mistake.file);
    };
    if let Some(shown) = &mistake.book_entry {
        place.section = shown.section;
    }
    go_back_sentences(&[place])
}

/// Tells of mistakes in several files, of which there are so many each.
fn explain_several_files(count: usize, first: &Mistake, files: BTreeMap<&str, usize>) -> String {
    let (mut steps, mut counts) = (vec![], vec![]);
    for (file, count) in files {
        let name = file.rsplit('/').next().unwrap_or_default();
        let Some(step) = Step::from_path(file) else { continue };
        steps.push(step);
        counts.push(format!("{count} in {name} of step {}", step.number()));
    }
    format!(
        "{count} mistakes that we know give this very picture, such as: {}.\n\
         By file: {}.\n{}",
        first.title,
        counts.join(", "),
        test_command_sentence(&steps),
    )
}
