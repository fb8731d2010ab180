//! Every slide of the lecture has a home in the book.

use super::built::BOOK;
use super::{assert_found, assert_none};
use book::Site;

/// A table of the slides: their titles, what they say, and their homes.
const SLIDES: &str = include_str!("slides.md");

/// Each slide whose home is not in the book, and each that a page speaks of and the
/// table does not have.
fn faults(book: &Site, slides: &str) -> Vec<String> {
    let rows = slides.lines().filter(|line| line.starts_with('|')).skip(2);
    let rows: Vec<_> = rows.map(cells).collect();
    let mut faults = vec![];
    for [title, says, home] in &rows {
        if *home != "—" && !is_there(book, home) {
            faults.push(format!("The book has no {home}, for {title}: {says}."));
        }
    }
    // "Ambient Term" is "Phong Reflection Model: Ambient Term".
    let is_known = |slide: &str| {
        let end = format!(": {slide}");
        rows.iter().any(|[title, ..]| *title == slide || title.ends_with(&end))
    };
    for page in book.chapters() {
        for slide in quoted(&page.text).iter().filter(|slide| !is_known(slide)) {
            let name = &page.name;
            faults
                .push(format!("{name} has a slide {slide:?}, slides.md has not."));
        }
    }
    faults
}

/// The title, what it says and the home in a row of the table.
fn cells(row: &str) -> [&str; 3] {
    let cells: Vec<_> = row.trim_matches(['|', ' ']).split(" | ").collect();
    cells.try_into().unwrap_or_else(|_| panic!("not three cells: {row}"))
}

/// Whether the book has a page of this name, or something with this id.
fn is_there(book: &Site, home: &str) -> bool {
    book.chapters().iter().any(|page| {
        page.name.strip_suffix(".html") == Some(home)
            || page.elements.iter().any(|one| one.get("id") == Some(home))
    })
}

/// The titles in a text: slide "A", slides "B" and "C".
fn quoted(text: &str) -> Vec<String> {
    let text = text.replace(['“', '”'], "\"").replace('’', "'");
    let mut titles = vec![];
    for (word, next) in [("lide \"", ""), ("lides \"", " and ")] {
        for rest in text.split(word).skip(1) {
            let mut parts = rest.split('"');
            titles.extend(parts.next().map(str::to_string));
            if parts.next() == Some(next) {
                titles.extend(parts.next().map(str::to_string));
            }
        }
    }
    titles
}

#[test]
fn every_slide_has_a_home() {
    assert_none(&faults(&BOOK, SLIDES));
}

#[test]
fn a_slide_without_a_home_is_found() {
    let slides = SLIDES.replace("| figure-ray |", "| figure-way |");
    assert_found(&faults(&BOOK, &slides), &["no figure-way, for Rays: A point"]);
}

#[test]
fn a_slide_that_is_not_in_the_table_is_found() {
    for text in ["Slide “A”", "the slides “Rays” and “A”", "/// (slide \"A\")"]
    {
        let book = BOOK.with_html(&format!("<p>{text}</p>"));
        assert_found(&faults(&book, SLIDES), &["step01_rays.html", "slide \"A\""]);
    }
}
