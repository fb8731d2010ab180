//! The book suffices: what a reader types from it compiles and draws its pictures,
//! at the end of each chapter.

use crate::assert_found;
use crate::book::BOOK;
use crate::listing::Listing;
use crate::source::SOURCE;
use crate::typist::{STEPS, Typist};
use book::{Page, Site};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;
use tests::target;

/// Held by the test that types: all type into one folder, so that little is compiled
/// twice.
static TYPING: Mutex<()> = Mutex::new(());

/// What is wrong at the end of the first chapter that does not suffice.
fn fault(book: &Site) -> Option<String> {
    let _typing = TYPING.lock();
    let typist = Typist { folder: target().join("typed") };
    let mut steps = STEPS.iter().peekable();
    let mut files: BTreeMap<&str, Vec<Listing>> = BTreeMap::new();
    typist.put_aside().expect("the files can be moved");
    for page in book.chapters() {
        for listing in Listing::all(page) {
            files.entry(listing.path).or_default().push(listing);
        }
        let step = steps.next_if(|step| page.name == format!("{step}.html"));
        let examples = examples(page);
        let checked = match step {
            None if examples.is_empty() => continue,
            _ => typist.write(&files).and_then(|()| match step {
                Some(step) => typist.check(step),
                None => typist.check_examples(&examples),
            }),
        };
        if let Err(what) = checked {
            return Some(format!("At the end of {}, {what}.", page.name));
        }
    }
    steps.next().map(|step| format!("The book has no chapter {step}.html."))
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
fn the_book_suffices_at_the_end_of_each_chapter() {
    assert_eq!(fault(&BOOK), None);
}

#[test]
fn every_group_of_a_table_of_contents_compiles_without_the_later_ones() {
    let _typing = TYPING.lock();
    let typist = Typist { folder: target().join("typed") };
    let mut files: BTreeMap<&str, Vec<Listing>> = BTreeMap::new();
    typist.put_aside().expect("the files can be moved");
    for listing in BOOK.chapters().into_iter().flat_map(Listing::all) {
        files.entry(listing.path).or_default().push(listing);
    }
    typist.write(&files).expect("the files can be written");
    typist.check_groups().unwrap_or_else(|error| panic!("{error:#}"));
}

const PHONG: &str = "step05_phong.html";

#[test]
fn a_program_that_does_not_compile_is_found() {
    let page = "step01_rays.html";
    let book = BOOK.with(page, "run(env!", "walk(env!");
    let words = ["At the end of", page, "steps/step01_rays/src/main.rs", "walk"];
    assert_found(&Vec::from_iter(fault(&book)), &words);
}

#[test]
fn another_picture_is_found() {
    let two = "|camera, _| step05_phong::picture(camera, 2))";
    let book = BOOK.with(PHONG, "step05_phong::picture)", two);
    let words = [PHONG, "step05_phong draws another picture", "pixels"];
    assert_found(&Vec::from_iter(fault(&book)), &words);
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
    let words = ["step03_nearest.html", "no program step03_nearest"];
    assert_found(&Vec::from_iter(fault(&book)), &words);
}

#[test]
fn a_solution_that_draws_another_picture_is_found() {
    let book = BOOK.with(
        SOLUTIONS,
        "fn picture(camera: &amp;Camera, samples: u32)",
        "fn picture(camera: &amp;Camera, _: u32)",
    );
    assert_found(
        &Vec::from_iter(fault(&book)),
        &["At the end of", SOLUTIONS, "samples"],
    );
}
