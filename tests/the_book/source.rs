//! Every line of every source file stands in the chapter of its step, once.

use super::assert_none;
use super::built::{book, files};
use super::listing::Listing;
use super::own_scene;
use super::typist::STEPS;
use ::book::{Files, Site};
use compare::workspace;
use std::fs;
use std::sync::LazyLock;

/// The files of the five crates, those beside the folder of the crates, and the one that
/// a page writes.
pub static SOURCE: LazyLock<Files> = LazyLock::new(|| {
    let steps = files("steps").0.into_iter();
    let steps = steps.map(|(path, bytes)| (format!("steps/{path}"), bytes));
    let mut source = Files(steps.collect());
    source.0.extend(files("book/reader").0);
    let rustfmt = ".rustfmt.toml";
    let bytes =
        fs::read(workspace().join(rustfmt)).expect("a file of the workspace");
    source.0.insert(rustfmt.to_owned(), bytes);
    source.0.insert(own_scene::PATH.to_string(), own_scene::printed().into_bytes());
    source
});

/// The page on which a file of a step has its place: an example, and what is of no step,
/// may stand on any page.
fn home(book: &Site, path: &str) -> Option<String> {
    let (step, file) = path.strip_prefix("steps/")?.split_once('/')?;
    let may_be_anywhere = file.starts_with("examples/") || !STEPS.contains(&step);
    let mut chapters = book.chapters().into_iter();
    let page = chapters.find(|page| {
        may_be_anywhere && Listing::all(page).any(|one| one.path == path)
    });
    Some(page.map_or(format!("{step}.html"), |page| page.name.clone()))
}

/// Whether the parts of a file may stand on several pages: the benchmark measures what
/// comes later, the rest of a manifest comes with it, and each step locks its picture.
fn is_spread(path: &str) -> bool {
    ["/Cargo.toml", "/benches/", "steps/locked/"]
        .iter()
        .any(|part| path.contains(part))
}

#[test]
fn every_listing_is_taken_from_its_file() {
    let (book, mut faults) = (book(), vec![]);
    for listing in book.chapters().into_iter().flat_map(Listing::all) {
        let Listing { at, path, lines: (first, last), code } = listing;
        // Our own manifest has the name of the reader's.
        let ours = fs::read_to_string(workspace().join(path));
        let own = SOURCE.text(path).filter(|text| text.contains(&code));
        let Some(source) = own.or(ours.as_deref().ok()).or(SOURCE.text(path))
        else {
            faults.push(format!("{at}: {path} is no file."));
            continue;
        };
        let source: Vec<_> = source.lines().collect();
        let source = source.get(first - 1..last).unwrap_or_default().join("\n");
        if source != code {
            let mut both = source.lines().zip(code.lines());
            let differ = both.position(|(a, b)| a != b);
            let line = first + differ.unwrap_or(0);
            faults.push(format!("{at}: line {line} of {path} is another there."));
        }
    }
    assert_none(&faults);
}

#[test]
fn no_rust_is_typed_by_hand() {
    let (book, mut faults) = (book(), vec![]);
    for page in book.chapters() {
        for code in
            page.all("figure:not(.listing) > pre code, :not(figure) > pre code")
        {
            let class = code.attr("class").unwrap_or_default();
            if class.is_empty() || class.contains("rust") {
                faults.push(format!(
                    "The code at {} is from no file.",
                    page.at(code)
                ));
            }
        }
    }
    assert_none(&faults);
}

#[test]
fn every_line_of_every_file_stands_in_its_chapter_once() {
    let (book, mut faults) = (book(), vec![]);
    for (path, text) in SOURCE.texts("") {
        let Some(home) = home(&book, path) else { continue };
        let mut times = vec![0; text.lines().count()];
        for page in book.chapters() {
            for listing in Listing::all(page).filter(|one| one.path == path) {
                if page.name != home && !is_spread(path) {
                    faults.push(format!("{}: {path} is of {home}.", listing.at));
                }
                let (first, last) = listing.lines;
                times[first - 1..last].iter_mut().for_each(|times| *times += 1);
            }
        }
        if let Some(at) = times.iter().position(|&times| times != 1) {
            let (line, times) = (at + 1, times[at]);
            faults.push(format!(
                "Line {line} of {path} stands {times} times in {home}."
            ));
        }
    }
    assert_none(&faults);
}
