//! The book suffices: what a reader types from it compiles at every heading, and each
//! command does what the page says. That in the end all of it is ours, `source` says.

use super::assert_found;
use super::built::BOOK;
use super::listing::Listing;
use super::own_scene;
use super::reading::{Asked, Event, events};
use super::source::SOURCE;
use super::typist::{STEPS, State, Typist, text};
use anyhow::{Context, Result, ensure};
use book::{Page, Site};
use std::collections::BTreeMap;
use tests::{is_thorough, target};

type Files<'a> = BTreeMap<&'a str, Vec<Listing<'a>>>;

/// A page and one of its commands: what a planted fault is about.
type Only<'a> = Option<(&'a str, &'a str)>;

/// Whether a command of a page is to be run.
fn is_asked(only: Only, page: &Page, command: &str) -> bool {
    only.is_none_or(|only| only == (page.name.as_str(), command))
}

/// The first thing that does not work for a reader who types everything, and runs every
/// command, or `only` one.
fn fault(book: &Site, only: Only) -> Option<String> {
    let typist = Typist { folder: target().join("typed") };
    typist.put_aside().expect("the files can be moved");
    let mut files = Files::new();
    book.chapters().into_iter().find_map(|page| {
        let done = typed(page, &typist, &mut files, only);
        done.err().map(|fault| format!("{fault:#}"))
    })
}

/// Types a page, and does what it says.
fn typed<'a>(
    page: &'a Page,
    typist: &Typist,
    files: &mut Files<'a>,
    only: Only,
) -> Result<()> {
    let mut drawn = vec![];
    for event in events(page) {
        match event {
            Event::Types(listing) => {
                files.entry(listing.path).or_default().push(listing);
            }
            Event::Runs(asked) => {
                let words = asked.words.join(" ");
                if is_asked(only, page, &words) && !is_exercise(&asked, files) {
                    typist.write(files)?;
                    let compared = typist.run(&asked);
                    drawn.extend(compared.with_context(|| {
                        format!("At {}, {words} does not do what it says", asked.at)
                    })?);
                }
            }
            Event::Section => {}
        }
    }
    let at_the_end = || format!("At the end of {}", page.name);
    let step = page.name.trim_end_matches(".html");
    if only.is_none() && STEPS.contains(&step) {
        let has_drawn = drawn.iter().any(|name| name == step);
        ensure!(has_drawn, "{}, no program {step} has drawn", at_the_end());
        typist.check_lock().with_context(at_the_end)?;
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

/// What each of these crates is like at each heading and each command of its chapter,
/// where it is not as it was at the one before.
fn states(book: &Site, steps: &[&str]) -> Vec<State> {
    let mut states: Vec<State> = vec![];
    for step in steps {
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
                states.push(State { name, files });
            }
        }
    }
    states
}

/// All that is typed, in one test: it goes into one folder, so that little is compiled
/// twice, and other tests go on while Cargo is waited for. To run each command takes long
/// even so.
#[test]
fn the_book_suffices() {
    assert!(30 <= states(&BOOK, &STEPS).len());
    assert_eq!(fault_on_the_way(&BOOK, &STEPS), None);
    a_group_that_needs_a_later_one_is_found();
    if !is_thorough() {
        return;
    }
    assert_eq!(fault(&BOOK, None), None);
    own_scene::the_rust_of_a_scene_draws_it();
    a_program_that_does_not_compile_is_found();
    a_file_that_comes_a_chapter_too_late_is_found();
    another_picture_is_found();
    a_line_that_is_not_printed_is_found();
}

/// A reader's workspace, once the whole book is typed.
pub fn whole() -> Typist {
    let typist = Typist { folder: target().join("typed") };
    let mut files = Files::new();
    typist.put_aside().expect("the files can be moved");
    for listing in BOOK.chapters().into_iter().flat_map(Listing::all) {
        files.entry(listing.path).or_default().push(listing);
    }
    typist.write(&files).expect("the files can be written");
    typist
}

/// What Cargo says of the states of these crates, once the whole book is typed.
fn fault_on_the_way(book: &Site, steps: &[&str]) -> Option<String> {
    let typist = whole();
    Some(typist.check_states(&states(book, steps)).err()?.to_string())
}

fn a_program_that_does_not_compile_is_found() {
    let page = "step01_rays.html";
    let book = BOOK.with(page, "run(env!", "walk(env!");
    let command = "cargo run -p step01_rays";
    let words = [page, command, "src/main.rs", "walk"];
    assert_found(&Vec::from_iter(fault(&book, Some((page, command)))), &words);
}

fn another_picture_is_found() {
    let page = "step02_sphere.html";
    let two = "|camera, _| step02_sphere::picture(camera, 2))";
    let book = BOOK.with(page, "step02_sphere::picture)", two);
    let words = [page, "step02_sphere draws another picture", "pixels"];
    let command = "cargo run -p step02_sphere";
    assert_found(&Vec::from_iter(fault(&book, Some((page, command)))), &words);
}

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
    let (page, command) = ("step03_nearest.html", "cargo run -p step03_nearest");
    let words = [page, command, "a bin target"];
    assert_found(&Vec::from_iter(fault(&book, Some((page, command)))), &words);
}

fn a_line_that_is_not_printed_is_found() {
    let (page, command) = ("step02_sphere.html", "cargo check -p step02_sphere");
    let line = format!("$ {command}\n");
    let book = BOOK.with(page, &line, &format!("{line}3 errors\n"));
    let words = [page, command, "does not print \"3 errors\""];
    assert_found(&Vec::from_iter(fault(&book, Some((page, command)))), &words);
}

fn a_group_that_needs_a_later_one_is_found() {
    let (page, group) = ("step01_rays.html", "mod ray;\npub use ray::Ray;\n");
    let early = format!("{group}pub use camera::Camera as Early;\n");
    let book = BOOK.with(page, group, &early);
    let words = ["Cargo says", "src/state_step01_rays_", "camera"];
    let fault = fault_on_the_way(&book, &STEPS[..1]);
    assert_found(&Vec::from_iter(fault), &words);
}
