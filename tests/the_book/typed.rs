//! The book suffices: what a reader types from it compiles at every heading, and each
//! command does what the page says. That in the end all of it is ours, `source` says.

use super::built::book;
use super::listing::{Listing, joined};
use super::reading::{Asked, Event, events};
use super::source::SOURCE;
use super::typist::{STEPS, State, Typist};
use ::book::Page;
use anyhow::{Context, Result, ensure};
use std::collections::BTreeMap;

/// What was typed of each file.
pub type Typed<'a> = BTreeMap<&'a str, Vec<Listing<'a>>>;

/// Types a page, and does what it says.
fn type_page<'a>(
    page: &'a Page,
    typist: &Typist,
    typed: &mut Typed<'a>,
) -> Result<()> {
    let mut drawn = vec![];
    for event in events(page) {
        match event {
            Event::Types(listing) => {
                typed.entry(listing.path).or_default().push(listing);
            }
            Event::Runs(asked) if !is_exercise(&asked, typed) => {
                typist.write(typed)?;
                let words = asked.words.join(" ");
                drawn.extend(typist.run(&asked).with_context(|| {
                    format!("At {}, {words} does not do what it says", asked.at)
                })?);
            }
            Event::Runs(_) | Event::Section => {}
        }
    }
    let step = page.name.trim_end_matches(".html");
    let has_drawn = !STEPS.contains(&step) || drawn.iter().any(|name| name == step);
    ensure!(has_drawn, "At the end of {}, no program {step} has drawn", page.name);
    Ok(())
}

/// Whether a command is for an exercise, which the reader writes.
fn is_exercise(asked: &Asked, typed: &Typed) -> bool {
    let Some(name) = asked.option("--example") else { return false };
    let file = format!("/examples/{name}.rs");
    !typed.keys().any(|path| path.ends_with(&file))
        && SOURCE.0.keys().any(|path| path.ends_with(&file))
}

/// What each crate is like at each heading and each command of its chapter, where it is
/// not as it was at the one before.
fn states() -> Vec<State> {
    let (book, mut states) = (book(), Vec::<State>::new());
    for step in STEPS {
        let mut typed = Typed::new();
        let folder = format!("steps/{step}/src/");
        for event in events(&book.pages[&format!("{step}.html")]) {
            if let Event::Types(listing) = event {
                if let Some(file) = listing.path.strip_prefix(&folder) {
                    typed.entry(file).or_default().push(listing);
                }
                continue;
            }
            let files = typed.iter().filter(|(file, _)| **file != "main.rs");
            let files: BTreeMap<_, _> = files
                .map(|(file, parts)| (file.to_string(), joined(parts)))
                .collect();
            let is_new = states.last().is_none_or(|last| last.files != files);
            if is_new && !files.is_empty() {
                let name = format!("state_{step}_{}", states.len());
                states.push(State { name, files });
            }
        }
    }
    states
}

/// A reader's workspace, once the whole book is typed.
pub fn whole() -> Typist {
    let (book, typist) = (book(), Typist::new());
    let mut typed = Typed::new();
    for listing in book.chapters().into_iter().flat_map(Listing::all) {
        typed.entry(listing.path).or_default().push(listing);
    }
    typist.write(&typed).expect("the files can be written");
    typist
}

// Each of these has the one folder of the reader for itself, so that little is compiled
// twice: the next waits.

#[test]
fn each_state_of_a_crate_compiles() -> Result<()> {
    let states = states();
    assert!(30 <= states.len());
    whole().check_states(&states)
}

#[test]
#[ignore = "takes minutes: cargo test -- --include-ignored"]
fn each_command_does_what_its_page_says() -> Result<()> {
    let (book, typist) = (book(), Typist::new());
    let mut typed = Typed::new();
    let mut pages = book.chapters().into_iter();
    pages.try_for_each(|page| type_page(page, &typist, &mut typed))
}
