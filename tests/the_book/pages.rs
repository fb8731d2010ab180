//! Nothing unexpanded is left, every picture and drawing has words for those who cannot
//! see it, an id stands for one thing, and the faces of the book have its letters.

use super::assert_none;
use super::built::book;
use ::book::{all, text};
use std::collections::HashSet;

/// What is only there when a directive or a formula was not expanded.
const LEFTOVERS: [&str; 4] = ["{{#", "$$", r"\frac", r"\begin{"];

#[test]
fn nothing_is_left_unexpanded() {
    let left = |page: &str, text: &str| {
        let left = LEFTOVERS.into_iter().filter(|left| text.contains(left));
        left.map(|left| format!("{left} is left in {page}.")).collect::<Vec<_>>()
    };
    let book = book();
    let pages = book.pages.values().flat_map(|page| {
        page.all("body").into_iter().flat_map(|body| left(&page.name, &text(body)))
    });
    assert_none(&pages.collect::<Vec<_>>());
}

#[test]
fn every_picture_and_drawing_has_words_and_every_id_is_one() {
    let (book, mut faults) = (book(), vec![]);
    for page in book.pages.values() {
        for img in page.all("img:not([role=img] > img)") {
            if img.attr("alt").is_none_or(|alt| alt.trim().is_empty()) {
                faults
                    .push(format!("The picture at {} has no words.", page.at(img)));
            }
        }
        for svg in page.all("figure svg") {
            let titles = all(svg, "title");
            if titles.iter().all(|title| text(*title).trim().is_empty()) {
                faults
                    .push(format!("The drawing at {} has no title.", page.at(svg)));
            }
        }
        let mut known = HashSet::new();
        let again =
            page.all("[id]").into_iter().filter(|e| !known.insert(e.attr("id")));
        faults.extend(
            again.map(|one| format!("There is a second {}.", page.at(one))),
        );
    }
    assert_none(&faults);
}

/// What is drawn in which face; the rest may be in any.
const FACES: [(&str, &str); 3] = [
    ("Course Math", "mi, mn, mo, mtext"),
    ("JetBrains Mono", "pre"),
    ("face", "body"),
];

/// Signs that are left to the faces of the reader's machine.
const ANYWHERE: [char; 6] = ['ᵀ', 'ⁿ', 'ₛ', '○', '●', '\u{200b}'];

#[test]
fn each_letter_has_its_face() {
    let (book, mut faults) = (book(), vec![]);
    let css = book.files.text("fonts/fonts.css").expect("the faces");
    for (family, selector) in FACES {
        let letters = letters(css, if family == "face" { "" } else { family });
        let has = |c: char| {
            c.is_whitespace()
                || ANYWHERE.contains(&c)
                || letters.iter().any(|&[a, b]| (a..=b).contains(&u32::from(c)))
        };
        for page in book.pages.values() {
            for one in page.all(selector) {
                if let Some(c) = text(one).chars().find(|&c| !has(c)) {
                    faults.push(format!(
                        "No {family} has the {c:?} at {}.",
                        page.at(one)
                    ));
                }
            }
        }
    }
    assert_none(&faults);
}

/// The first and the last of the letters in a row that the faces of a family have.
fn letters(css: &str, family: &str) -> Vec<[u32; 2]> {
    let number = |text| u32::from_str_radix(text, 16).expect("a letter");
    let faces = css.lines().filter(|line| line.contains(&format!("\"{family}")));
    let ranges = faces.filter_map(|face| face.split_once("unicode-range:"));
    let ranges = ranges.flat_map(|(_, ranges)| ranges.split(';').next());
    let ranges = ranges.flat_map(|ranges| ranges.split(','));
    ranges
        .map(|range| {
            let range = range.trim().trim_start_matches("U+");
            let (first, last) = range.split_once('-').unwrap_or((range, range));
            [number(first), number(last)]
        })
        .collect()
}
