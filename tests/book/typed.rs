//! The book suffices: what a reader types from it compiles at every heading, and each
//! command does what the page says.

use crate::assert_found;
use crate::book::BOOK;
use crate::listing::Listing;
use crate::reading::{Asked, Event, events};
use crate::source::SOURCE;
use crate::typist::{STEPS, State, Typist, text};
use anyhow::{Context, Result, ensure};
use book::{Page, Site};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;
use tests::target;

/// Held by the test that types: all type into one folder, so that little is compiled
/// twice.
static TYPING: Mutex<()> = Mutex::new(());

type Files<'a> = BTreeMap<&'a str, Vec<Listing<'a>>>;

/// The first thing that does not work for a reader who types everything, and runs every
/// command: on each page, or on one alone.
fn fault(book: &Site, only: Option<&str>) -> Option<String> {
    let _typing = TYPING.lock();
    let typist = Typist { folder: target().join("typed") };
    typist.put_aside().expect("the files can be moved");
    let mut files = Files::new();
    book.chapters().into_iter().find_map(|page| {
        let is_asked = only.is_none_or(|only| page.name == only);
        let done = typed(page, &typist, &mut files, is_asked);
        done.err().map(|fault| format!("{fault:#}"))
    })
}

/// Types a page, and does what it says.
fn typed<'a>(
    page: &'a Page,
    typist: &Typist,
    files: &mut Files<'a>,
    is_asked: bool,
) -> Result<()> {
    let mut drawn = vec![];
    for event in events(page) {
        match event {
            Event::Types(listing) => {
                files.entry(listing.path).or_default().push(listing);
            }
            Event::Runs(asked) if is_asked && !is_exercise(&asked, files) => {
                typist.write(files)?;
                let compared = typist.run(&asked);
                let words = asked.words.join(" ");
                drawn.extend(compared.with_context(|| {
                    format!("At {}, {words} does not do what it says", asked.at)
                })?);
            }
            _ => {}
        }
    }
    let at_the_end = || format!("At the end of {}", page.name);
    let step = page.name.trim_end_matches(".html");
    if is_asked && STEPS.contains(&step) {
        let has_drawn = drawn.iter().any(|name| name == step);
        ensure!(has_drawn, "{}, no program {step} has drawn", at_the_end());
        typist.check_lock().with_context(at_the_end)?;
    }
    if is_asked && page.name == SOLUTIONS {
        typist.write(files)?;
        typist.check_examples(&examples(page)).with_context(at_the_end)?;
    }
    Ok(())
}

/// Whether a command is for an exercise, which the reader writes.
fn is_exercise(asked: &Asked, files: &Files) -> bool {
    let file = |name| format!("/examples/{name}.rs");
    asked.option("--example").is_some_and(|name| {
        !files.keys().any(|path| path.ends_with(&file(name)))
            && SOURCE.0.keys().any(|path| path.ends_with(&file(name)))
    })
}

/// What each crate is like at each heading and each command of its chapter, where it is
/// not as it was at the one before.
fn states(book: &Site) -> Vec<State> {
    let mut states: Vec<State> = vec![];
    for step in STEPS {
        let mut files = Files::new();
        let folder = format!("steps/{step}/src/");
        for event in events(&book.pages[&format!("{step}.html")]) {
            if let Event::Types(listing) = event {
                if let Some(file) = listing.path.strip_prefix(&folder) {
                    files.entry(file).or_default().push(listing);
                }
                continue;
            }
            let files = files.iter().filter(|(file, _)| **file != "main.rs");
            let files: BTreeMap<_, _> = files
                .map(|(file, parts)| (file.to_string(), text(parts)))
                .collect();
            if states.last().is_none_or(|last| last.files != files)
                && !files.is_empty()
            {
                let name = format!("state_{step}_{}", states.len());
                states.push(State { name, step: step.to_owned(), files });
            }
        }
    }
    states
}

const SOLUTIONS: &str = "solutions.html";

/// The names of the examples on a page.
fn examples(page: &Page) -> BTreeSet<&str> {
    let paths = Listing::all(page).map(|listing| listing.path);
    paths
        .filter_map(|path| path.split_once("/examples/")?.1.strip_suffix(".rs"))
        .collect()
}

#[test]
fn the_book_suffices() {
    assert_eq!(fault(&BOOK, None), None);
}

/// What Cargo says of the states on the way, once the whole book is typed.
fn fault_on_the_way(book: &Site) -> Option<String> {
    let _typing = TYPING.lock();
    let typist = Typist { folder: target().join("typed") };
    let mut files = Files::new();
    typist.put_aside().expect("the files can be moved");
    for listing in BOOK.chapters().into_iter().flat_map(Listing::all) {
        files.entry(listing.path).or_default().push(listing);
    }
    typist.write(&files).expect("the files can be written");
    Some(typist.check_states(&states(book)).err()?.to_string())
}

#[test]
fn every_state_on_the_way_compiles() {
    assert!(30 <= states(&BOOK).len());
    assert_eq!(fault_on_the_way(&BOOK), None);
}

const PHONG: &str = "step05_phong.html";

#[test]
fn a_program_that_does_not_compile_is_found() {
    let page = "step01_rays.html";
    let book = BOOK.with(page, "run(env!", "walk(env!");
    let words = [page, "cargo run -p step01_rays", "src/main.rs", "walk"];
    assert_found(&Vec::from_iter(fault(&book, Some(page))), &words);
}

#[test]
fn another_picture_is_found() {
    let two = "|camera, _| step05_phong::picture(camera, 2))";
    let book = BOOK.with(PHONG, "step05_phong::picture)", two);
    let words = [PHONG, "step05_phong draws another picture", "pixels"];
    assert_found(&Vec::from_iter(fault(&book, Some(PHONG))), &words);
}

#[test]
fn a_file_that_comes_a_chapter_too_late_is_found() {
    let main = "steps/step03_nearest/src/main.rs";
    let late = format!(
        "<figure class=\"listing\" data-path=\"{main}\" data-lines=\"1-7\">\
         <code class=\"language-rust\">{}</code></figure></main>",
        SOURCE.text(main).expect("the program of step 3"),
    );
    let book = BOOK
        .with("step03_nearest.html", &format!("\"{main}\""), "\"README\"")
        .with("step04_diffuse.html", "</main>", &late);
    let page = "step03_nearest.html";
    let words = [page, "cargo run -p step03_nearest", "a bin target"];
    assert_found(&Vec::from_iter(fault(&book, Some(page))), &words);
}

#[test]
fn a_solution_that_draws_another_picture_is_found() {
    let book = BOOK.with(
        SOLUTIONS,
        "fn picture(camera: &amp;Camera, samples: u32)",
        "fn picture(camera: &amp;Camera, _: u32)",
    );
    assert_found(
        &Vec::from_iter(fault(&book, Some(SOLUTIONS))),
        &["At the end of", SOLUTIONS, "samples"],
    );
}

#[test]
fn a_line_that_is_not_printed_is_found() {
    let page = "step02_sphere.html";
    let book = BOOK.with(
        page,
        "$ cargo check -p step02_sphere\n",
        "$ cargo check -p step02_sphere\n3 errors\n",
    );
    let words =
        [page, "cargo check -p step02_sphere", "does not print \"3 errors\""];
    assert_found(&Vec::from_iter(fault(&book, Some(page))), &words);
}

#[test]
fn a_group_that_needs_a_later_one_is_found() {
    let group = "mod ray;\npub use ray::Ray;\n";
    let book = BOOK.with(
        "step01_rays.html",
        group,
        &format!("{group}pub use camera::Camera;\n"),
    );
    let words = ["Cargo says", "examples/state_step01_rays_", "camera"];
    assert_found(&Vec::from_iter(fault_on_the_way(&book)), &words);
}
