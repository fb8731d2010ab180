//! Every line of every source file stands in the chapter of its step, once.

use super::built::{BOOK, files};
use super::listing::Listing;
use super::own_scene;
use super::{assert_found, assert_none};
use book::{Files, Page, Site};
use gallery::workspace;
use std::fs;
use std::sync::LazyLock;

/// The files of the five crates, those beside the folder of the crates, and the one that
/// a page writes.
pub static SOURCE: LazyLock<Files> = LazyLock::new(|| {
    let mut source = Files::default();
    for (path, bytes) in files("steps").0 {
        source.0.insert(format!("steps/{path}"), bytes);
    }
    for path in ["book/reader/Cargo.toml", ".rustfmt.toml"] {
        let bytes =
            fs::read(workspace().join(path)).expect("a file of the workspace");
        let path = path.strip_prefix("book/reader/").unwrap_or(path);
        source.0.insert(path.to_string(), bytes);
    }
    source.0.insert(own_scene::PATH.to_string(), own_scene::printed().into_bytes());
    source
});

/// Each listing that is not what its caption says, or not from a step.
fn wrong_listings(book: &Site, source: &Files) -> Vec<String> {
    let listings = book.chapters().into_iter().flat_map(Listing::all);
    let checked = listings.map(|listing| listing.check(source.text(listing.path)));
    checked.filter_map(|wrong| Some(wrong.err()?.to_string())).collect()
}

/// The page on which a file of a step has its place: an example may stand on any page.
fn home(book: &Site, path: &str) -> Option<String> {
    let (step, file) = path.strip_prefix("steps/")?.split_once('/')?;
    let has_it = |page: &&Page| Listing::all(page).any(|one| one.path == path);
    let example = file.starts_with("examples/");
    let page = book.chapters().into_iter().find(|page| example && has_it(page));
    Some(page.map_or(format!("{step}.html"), |page| page.name.clone()))
}

/// Whether the parts of a file may stand on several pages: the benchmark measures what
/// comes later, and the rest of a manifest comes with it.
fn is_spread(path: &str) -> bool {
    path.ends_with("/Cargo.toml") || path.contains("/benches/")
}

/// Each file with a line that does not stand in its chapter, stands there twice or
/// stands in another one too.
fn wrong_files(book: &Site, source: &Files) -> Vec<String> {
    let mut faults = vec![];
    for (path, text) in source.texts("") {
        let Some(home) = home(book, path) else { continue };
        let mut times = vec![0; text.lines().count()];
        for page in book.chapters() {
            for listing in Listing::all(page).filter(|one| one.path == path) {
                if page.name != home && !is_spread(path) {
                    let at = &listing.at;
                    faults.push(format!(
                        "The listing on {at} is from {path}, whose place is {home}."
                    ));
                } else if let Some((first, last)) = listing.lines() {
                    let shown = times.iter_mut().take(last).skip(first.max(1) - 1);
                    shown.for_each(|times| *times += 1);
                }
            }
        }
        if let Some(at) = times.iter().position(|&times| times != 1) {
            let (line, times) = (at + 1, times[at]);
            faults.push(format!(
                "Line {line} of {path} stands {times} times in {home}, not once."
            ));
        }
    }
    faults
}

const PAGE: &str = "step01_rays.html";
const RAY: &str = "steps/step01_rays/src/ray.rs";
const FIGURE: &str =
    r#"data-path="steps/step01_rays/src/ray.rs" data-lines="1-22""#;

/// Fails unless one listing of `book` is wrong, and the sentence holds these words.
#[track_caller]
fn found(book: &Site, words: &[&str]) {
    assert_found(&wrong_listings(book, &SOURCE), words);
}

/// The first line of the reader's manifest, but for its members, that ours has not.
fn line_of_another_workspace(manifest: &str) -> Option<&str> {
    let ours = fs::read_to_string(workspace().join("Cargo.toml"));
    let ours = ours.expect("the manifest of the workspace");
    let is_ours = |line: &&str| ours.lines().any(|one| one == *line);
    let mut others = manifest.lines().filter(|line| !is_ours(line));
    others.find(|line| !line.starts_with("members = "))
}

#[test]
fn what_the_reader_depends_on_is_what_we_do() {
    let manifest = SOURCE.text("Cargo.toml").expect("the manifest of a reader");
    assert_eq!(line_of_another_workspace(manifest), None);
    let other = manifest.replace("rayon = \"1.11\"", "rayon = \"1.10\"");
    assert_eq!(line_of_another_workspace(&other), Some("rayon = \"1.10\""));
}

#[test]
fn every_listing_is_what_its_caption_says() {
    assert_none(&wrong_listings(&BOOK, &SOURCE));
}

#[test]
fn every_line_of_every_file_stands_in_its_chapter_once() {
    assert_none(&wrong_files(&BOOK, &SOURCE));
}

#[test]
fn a_changed_line_is_found() {
    let (old, new) = ("self.start + t", "self.start - t");
    let shown = "self.start - t * self.direction";
    found(&BOOK.with(PAGE, old, new), &[PAGE, RAY, "Line 20", shown]);
    let source = SOURCE.with(RAY, old, new);
    let words = [PAGE, RAY, "Line 20", shown];
    assert_found(&wrong_listings(&BOOK, &source), &words);
}

#[test]
fn a_missing_line_is_found() {
    let line = "    /// S, the point where the ray starts.\n";
    found(&BOOK.with(PAGE, line, ""), &[PAGE, RAY, "Line 11", "pub start: DVec3"]);
    let source = SOURCE.with(RAY, "use glam", "use std::fmt;\nuse glam");
    let words = ["Line 23 of", RAY, "0 times", PAGE];
    assert_found(&wrong_files(&BOOK, &source), &words);
}

#[test]
fn a_line_too_many_is_found() {
    let end = "self.start + t * self.direction\n    }\n}";
    let book = BOOK.with(PAGE, end, &format!("{end}\n// The end"));
    found(&book, &[PAGE, "Line 23", "None", "// The end"]);
}

#[test]
fn a_file_without_a_listing_is_found() {
    let mut source = SOURCE.clone();
    source
        .0
        .insert("steps/step02_sphere/src/new.rs".to_string(), b"// New\n".into());
    let words = ["Line 1 of steps/step02_sphere/src/new.rs", "0 times"];
    assert_found(&wrong_files(&BOOK, &source), &words);
}

#[test]
fn a_listing_that_stands_twice_or_in_another_chapter_is_found() {
    let again =
        format!("<figure class=\"listing\" {FIGURE}><code></code></figure></main>");
    let book = BOOK.with(PAGE, "</main>", &again);
    let words = ["Line 1 of", RAY, "2 times", PAGE];
    assert_found(&wrong_files(&book, &SOURCE), &words);
    let book = BOOK.with("step02_sphere.html", "</main>", &again);
    let words = ["step02_sphere.html", RAY, PAGE];
    assert_found(&wrong_files(&book, &SOURCE), &words);
}

#[test]
fn a_wrong_place_is_found() {
    let with_lines =
        |lines| BOOK.with(PAGE, FIGURE, &FIGURE.replace("1-22", lines));
    found(&with_lines("2-22"), &["caption", PAGE, "lines 2–22 of 22"]);
    found(&with_lines("1-23"), &[PAGE, "1-23", RAY, "has 22"]);
}

#[test]
fn rust_from_elsewhere_is_found() {
    let typed = "<pre><code class=\"language-rust\">let x = 1;</code></pre>";
    found(&BOOK.with_html(typed), &[PAGE, "no file"]);
    let moved = FIGURE.replace("ray.rs", "way.rs");
    found(&BOOK.with(PAGE, FIGURE, &moved), &[PAGE, "way.rs, which is no file"]);
    let figure = "<figure class=\"listing\" data-path=\"book/builder/lib.rs\">";
    let book = BOOK.with_html(&format!("{figure}{typed}</figure>"));
    found(&book, &[PAGE, "book/builder/lib.rs", "no step"]);
}
