use crate::answer::{Told, stages};
use crate::edit::{Edit, Fault};
use crate::name::Name;
use check::{Answer, Locked, check};
use gallery::Step;
use std::fs::File;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::{error::Error, io::BufReader, path::Path};

/// What becomes of a reader who asks `check`.
pub struct Outcome {
    /// What it is worth.
    pub kind: Kind,
    /// What was told, or why it is wrong.
    pub why: String,
    /// The whole answer.
    pub text: String,
}

/// What an answer is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A name that explains every pixel, and sends the reader to the file.
    Named,
    /// The stage, and numbers that point at the line.
    Told,
    /// A name that explains every pixel, but sends the reader to another file.
    Elsewhere,
    /// The stage alone; or one of two mistakes.
    Stage,
    /// Nothing that helps.
    Nothing,
    /// Something that is not so.
    Wrong,
}

/// Asks `check` for one picture and judges what it says.
pub fn judged(
    edit: &Edit,
    step: Step,
    path: &Path,
    locked: &[Locked],
) -> Result<Outcome, Box<dyn Error>> {
    let edit = &edit.until(step);
    let png = BufReader::new(File::open(path)?);
    let asked = || check(png, "", Some(step.name()), locked);
    let Ok(Answer { code, text, .. }) = catch_unwind(AssertUnwindSafe(asked))
    else {
        let (kind, why) = (Kind::Wrong, "panics".to_owned());
        return Ok(Outcome { kind, why, text: String::new() });
    };
    let yours = image::open(path)?.to_rgb8();
    let (kind, why) = match code {
        1 => {
            let names = Name::all(&text);
            let lie = names.iter().find_map(|name| name.lie(&yours, step, &text));
            match lie {
                Some(lie) => (Kind::Wrong, lie),
                None => verdict(edit, &names, &text),
            }
        }
        _ => (Kind::Wrong, format!("exit code {code}")),
    };
    Ok(Outcome { kind, why, text })
}

/// What an answer without a wrong name is worth.
fn verdict(edit: &Edit, names: &[Name], text: &str) -> (Kind, String) {
    let table = stages(text);
    let first = text.lines().next().unwrap_or_default();
    let exact: Vec<_> = names.iter().filter(|name| name.is_exact()).collect();
    // What gives every pixel is another cause, and no lie.
    let is_exact = !exact.is_empty() || text.contains("in every pixel, ");
    let lie = excuse(edit, text).or_else(|| missed(edit, &table));
    let wrong = || invented(edit, &table).filter(|_| !is_exact);
    if let Some(lie) = lie.or_else(wrong) {
        return (Kind::Wrong, lie);
    }
    if exact.iter().any(|name| name.leads_to(&edit.changes)) {
        return (Kind::Named, told(&exact));
    }
    let wrong = || table.iter().filter(|told| told.verdict == "WRONG");
    let is_found =
        |fault: &&Fault| wrong().any(|told| told.is_about(fault, &edit.changes));
    let is_told = |fault: &&Fault| {
        wrong().any(|told| {
            told.is_about(fault, &edit.changes)
                && told.points_at(fault, &edit.changes)
        }) || (fault.is_in("size") || first.contains("it is grey"))
            && fault.words.iter().any(|word| text.contains(word))
            || is_beside(edit, fault, text)
    };
    let all: Vec<_> = wrong().flat_map(|told| told.numbers.clone()).collect();
    if edit.faults.iter().all(|fault| is_told(&fault)) {
        return (Kind::Told, all.join("; "));
    }
    match edit.faults.iter().any(|fault| is_found(&fault)) {
        true => (Kind::Stage, all.join("; ")),
        false if !is_exact => (Kind::Nothing, first.to_owned()),
        false if exact.is_empty() => (Kind::Elsewhere, all.join("; ")),
        false => (Kind::Elsewhere, told(&exact)),
    }
}

/// Whether it is told beside the table: as an angle, or as highlights that are missing.
fn is_beside(edit: &Edit, fault: &Fault, text: &str) -> bool {
    let mut its = edit.changes.iter().zip(&edit.faults);
    let its = its.find(|(_, other)| *other == fault);
    let Some(path) = its.map(|(change, _)| change.path()) else { return false };
    let is_in = |line: &str| match line {
        _ if line.contains("look at what becomes of θ") => {
            ["camera.rs", "program.rs"].iter().any(|file| path.ends_with(file))
        }
        _ => line.starts_with("No highlight is in it") && line.contains(&path),
    };
    text.lines().any(is_in)
}

fn told(names: &[&Name]) -> String {
    names.iter().map(ToString::to_string).collect::<Vec<_>>().join(" = ")
}

/// What is said to be harmless, and is not.
fn excuse(edit: &Edit, text: &str) -> Option<String> {
    let is_only =
        |stage| edit.faults.iter().all(|fault: &Fault| fault.is_in(stage));
    let told = |words: &str| text.contains(words).then(|| format!("says: {words}"));
    let rounding = || told("That is rounding").filter(|_| !is_only("bytes"));
    let is_angle = |fault: &Fault| is_beside(edit, fault, text);
    let is_told = is_only("size") || edit.faults.iter().all(is_angle);
    told("Right but for").filter(|_| !is_told).or_else(rounding)
}

/// A stage that the table calls wrong, and that is not.
fn invented(edit: &Edit, table: &[Told]) -> Option<String> {
    let is_fault = |told: &Told| {
        edit.faults.iter().any(|fault| told.is_about(fault, &edit.changes))
    };
    let wrong =
        table.iter().find(|told| told.verdict == "WRONG" && !is_fault(told));
    wrong.map(|Told { stage, numbers, .. }| {
        format!("calls {stage} wrong: {}", numbers.join("; "))
    })
}

/// A stage that the table calls right, and that is not.
fn missed(edit: &Edit, table: &[Told]) -> Option<String> {
    let is_missed = |fault: &&Fault| {
        let mut its = table.iter().filter(|told| told.is_of(fault)).peekable();
        let is_told = |told: &Told| {
            told.verdict == "WRONG" && told.points_at(fault, &edit.changes)
        };
        its.peek().is_some()
            && its.all(|told| told.verdict == "right")
            && !table.iter().any(is_told)
    };
    let missed = edit.faults.iter().find(is_missed)?;
    Some(format!("calls {} right", missed.stages.join(" and ")))
}
