//! Tries natural one-place edits of the steps, those of `tests/gallery/edits`, and tells
//! what `check` says of their pictures. Words choose the edits whose titles hold one of
//! them:
//!
//! ```text
//! cargo run -p gallery --example edits -- D_v attenuation
//! ```

mod edit;
mod outcome;
mod project;
mod view;

use edit::{Edit, edits};
use outcome::{Outcome, judged};
use project::Project;
use std::collections::BTreeMap;
use std::{env, error::Error, fs, time::Instant};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let is_chosen = |edit: &Edit| {
        words.is_empty() || words.iter().any(|word| edit.title.contains(word))
    };
    let edits: Vec<_> = edits()?.into_iter().filter(is_chosen).collect();
    let project = Project::new()?;
    let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
    for edit in &edits {
        match project.pictures(edit) {
            Err(fault) => println!("{}: {fault}", edit.title),
            Ok(pictures) => {
                for (step, path) in pictures {
                    let start = Instant::now();
                    let Outcome { kind, why, text } = judged(edit, step, &path)?;
                    *counts.entry(kind).or_default() += 1;
                    let number = step.number();
                    let time = start.elapsed().as_secs_f64();
                    println!(
                        "{kind:8}| {number} | {} | {why} ({time:.1} s)",
                        edit.title
                    );
                    fs::write(path.with_extension("txt"), text)?;
                }
            }
        }
    }
    println!("\n{counts:?}");
    Ok(())
}
