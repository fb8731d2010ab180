use crate::place::{Place, back};
use crate::table::{known, sum};
use crate::{Mistake, Step};
use image::RgbImage;
use std::collections::BTreeMap;

/// The most lines of a diff that is told.
const LINES: usize = 4;

/// The most mistakes that are told with their titles.
const TITLES: usize = 3;

/// Where these very pixels are in the list: which mistakes give them.
pub(crate) fn listed(yours: &RgbImage, asked: &str) -> Option<String> {
    let all = known(sum(yours));
    let its: Vec<_> = all.iter().filter(|(_, name)| name == asked).collect();
    let all = if its.is_empty() { all.iter().collect() } else { its };
    let (first, name) = all.first()?;
    let mistakes: Vec<_> = all.iter().map(|(mistake, _)| mistake).collect();
    let mut files: BTreeMap<&str, usize> = BTreeMap::new();
    mistakes.iter().for_each(|one| *files.entry(&one.file).or_default() += 1);
    let mut text = String::new();
    if name != asked {
        text += &format!(
            "These are the pixels of {name} with a mistake in it, not of {asked}.\n"
        );
    }
    match (&mistakes[..], files.len()) {
        ([_], _) => text += &one(first),
        (all, 1) => text += &some(all),
        (all, _) => text += &many(all, &files),
    }
    Some(text)
}

/// One mistake: its title, its diff, and where to go back to.
fn one(mistake: &Mistake) -> String {
    let Mistake { title, shown, .. } = mistake;
    let why =
        shown.as_ref().map_or(String::new(), |shown| format!("{}\n", shown.why));
    let start =
        "Not right: your picture is, in every pixel, what this mistake gives";
    format!("{start}: {title}.\n{}{why}{}", diff(mistake), back_to(mistake))
}

/// Its diff, cut where it is long.
fn diff(mistake: &Mistake) -> String {
    let diff = mistake.diff();
    let lines: Vec<_> = diff.lines().map(|line| format!("  {line}\n")).collect();
    match lines.len() {
        0..=LINES => lines.concat(),
        _ => lines[..LINES - 1].concat() + "  …\n",
    }
}

/// Several in one file: the likeliest.
fn some(all: &[&Mistake]) -> String {
    let (count, first) = (all.len(), all[0]);
    let titles: Vec<_> = all.iter().take(TITLES).map(|one| one.title).collect();
    let likeliest = if TITLES < count { ", such as" } else { ":" };
    format!(
        "Not right: your picture is, in every pixel, what {count} mistakes in one file \
         give{likeliest}\n  {}.\n{}{}",
        titles.join("; "),
        diff(first),
        back_to(first)
    )
}

/// Many, in several files.
fn many(all: &[&Mistake], files: &BTreeMap<&str, usize>) -> String {
    let mut files: Vec<_> = files.iter().collect();
    files.sort_by_key(|(_, count)| usize::MAX - **count);
    let counts: Vec<_> = files
        .iter()
        .map(|(file, count)| {
            let name = file.rsplit('/').next().unwrap_or_default();
            let step = Step::of(file).map_or(0, Step::number);
            format!("{count} in {name} of step {step}")
        })
        .collect();
    let mut steps: Vec<_> = all.iter().filter_map(|one| one.step()).collect();
    steps.sort();
    steps.dedup();
    let steps: Vec<_> = steps.into_iter().map(Step::name).collect();
    format!(
        "Not right: {} mistakes that we know give this very picture, such as: {}.\n\
         They are {}.\nYour tests by hand tell them apart: cargo test -p {} --test by_hand\n",
        all.len(),
        all[0].title,
        counts.join(", "),
        steps.join(" -p "),
    )
}

fn back_to(mistake: &Mistake) -> String {
    let Some(mut place) = Place::of(&mistake.file) else {
        return format!("Compare with {}.\n", mistake.file);
    };
    if let Some(shown) = &mistake.shown {
        place.section = shown.section;
    }
    back(&[place])
}
