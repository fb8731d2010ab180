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
    if let Some(lie) = excuse(edit, text).or_else(|| lie(edit, &table)) {
        return (Kind::Wrong, lie);
    }
    let exact: Vec<_> = names.iter().filter(|name| name.is_exact()).collect();
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
    };
    let all: Vec<_> = wrong().flat_map(|told| told.numbers.clone()).collect();
    if edit.faults.iter().all(|fault| is_told(&fault)) {
        return (Kind::Told, all.join("; "));
    }
    match edit.faults.iter().any(|fault| is_found(&fault)) {
        true => (Kind::Stage, all.join("; ")),
        false if exact.is_empty() => (Kind::Nothing, first.to_owned()),
        false => (Kind::Elsewhere, told(&exact)),
    }
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
    told("Right but for").filter(|_| !is_only("size")).or_else(rounding)
}

/// What the table says that is not so.
fn lie(edit: &Edit, table: &[Told]) -> Option<String> {
    let is_fault = |told: &Told| {
        edit.faults.iter().any(|fault| told.is_about(fault, &edit.changes))
    };
    let wrong =
        table.iter().find(|told| told.verdict == "WRONG" && !is_fault(told));
    if let Some(Told { stage, numbers, .. }) = wrong {
        return Some(format!("calls {stage} wrong: {}", numbers.join("; ")));
    }
    let is_missed = |fault: &&Fault| {
        let mut its = table.iter().filter(|told| told.is_of(fault)).peekable();
        its.peek().is_some() && its.all(|told| told.verdict == "right")
    };
    let missed = edit.faults.iter().find(is_missed)?;
    Some(format!("calls {} right", missed.stages.join(" and ")))
}
