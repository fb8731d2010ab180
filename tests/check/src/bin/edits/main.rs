//! Tries natural one-place edits of the steps, those of `tests/check/edits`, and tells
//! what `check` says of their pictures. Words choose the edits whose titles hold one of
//! them; `--draw` draws and does not ask, `--ask` asks and does not draw.
//!
//! ```text
//! cargo run --bin edits -- D_v attenuation
//! ```
//!
//! Pictures and answers are in `target/edits/pictures`. A picture is drawn once.

mod answer;
mod edit;
mod name;
mod outcome;
mod project;
mod view;

use check::Locked;
use edit::{Edit, edits};
use gallery::Step;
use outcome::{Kind, judged};
use project::Project;
use std::collections::BTreeMap;
use std::{env, error::Error, fs, path::Path, time::Instant};

fn main() -> Result<(), Box<dyn Error>> {
    let (options, words): (Vec<_>, Vec<_>) =
        env::args().skip(1).partition(|word| word.starts_with("--"));
    let is_told = |option: &str| options.iter().any(|word| word == option);
    let is_chosen = |edit: &Edit| {
        words.is_empty() || words.iter().any(|word| edit.title.contains(word))
    };
    let edits: Vec<_> = edits()?.into_iter().filter(is_chosen).collect();
    let (project, locked) = (Project::new(is_told("--ask"))?, Locked::all()?);
    let mut counts = Counts::new();
    for edit in &edits {
        let pictures = match is_told("--ask") {
            true => project.kept(edit),
            false => project.pictures(edit),
        };
        let pictures = pictures.unwrap_or_else(|fault| {
            println!("not tried | {} | {fault}", edit.title);
            vec![]
        });
        for (k, (step, path)) in pictures.iter().enumerate() {
            if !is_told("--draw") {
                let kind = ask(edit, *step, path, &locked)?;
                *counts.entry((edit.group(k == 0), kind)).or_default() += 1;
            }
        }
    }
    print(&counts);
    Ok(())
}

/// How many pictures of a group had an answer of a kind.
type Counts = BTreeMap<(&'static str, Kind), usize>;

fn print(counts: &Counts) {
    for ((group, kind), count) in counts {
        let of_group = counts.iter().filter(|((other, _), _)| other == group);
        let all: usize = of_group.map(|(_, count)| count).sum();
        println!("{group}: {kind:?} {count} of {all}");
    }
}

/// Asks for one picture, prints a line of the table, and keeps the whole answer.
fn ask(
    edit: &Edit,
    step: Step,
    path: &Path,
    locked: &[Locked],
) -> Result<Kind, Box<dyn Error>> {
    let start = Instant::now();
    let outcome = judged(edit, step, path, locked)?;
    let time = start.elapsed().as_secs_f64();
    let (kind, why) = (format!("{:?}", outcome.kind), outcome.why);
    println!("{kind:7} | {} | {} | {why} | {time:.1} s", step.number(), edit.title);
    fs::write(path.with_extension("txt"), outcome.text)?;
    Ok(outcome.kind)
}
