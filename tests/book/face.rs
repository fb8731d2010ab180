//! The face of the formulas has each of their letters.

use crate::book::BOOK;
use crate::{assert_found, assert_none};
use book::Site;

/// The parts of a formula that hold its letters.
const TOKENS: [&str; 4] = ["mi", "mn", "mo", "mtext"];

/// Each letter of a formula that would be drawn in another face.
fn faults(book: &Site) -> Vec<String> {
    let ranges = ranges(book.files.text("fonts/fonts.css").unwrap_or_default());
    let mut faults = vec![];
    for page in book.pages.values() {
        for token in TOKENS.into_iter().flat_map(|tag| page.all(tag)) {
            let is_missing = |c: &char| {
                !c.is_whitespace()
                    && !ranges
                        .iter()
                        .any(|[a, b]| (*a..=*b).contains(&u32::from(*c)))
            };
            if let Some(c) = token.text.chars().find(is_missing) {
                faults.push(format!(
                    "The formulas' face has no {c:?} ({:X}), at {}.",
                    u32::from(c),
                    page.at(token)
                ));
            }
        }
    }
    faults
}

/// The first and the last of the letters in a row that the face has.
fn ranges(css: &str) -> Vec<[u32; 2]> {
    let face = css.lines().find(|line| line.contains("\"Course Math\""));
    let face = face.and_then(|line| line.split_once("unicode-range:"));
    let (_, all) = face.expect("the letters of the formulas' face");
    let number = |text: &str| u32::from_str_radix(text, 16).expect("a letter");
    let range = |text: &str| {
        let text = text.trim().trim_end_matches([';', ' ', '}']);
        let text = text.trim_start_matches("U+");
        let (a, b) = text.split_once('-').unwrap_or((text, text));
        [number(a), number(b)]
    };
    all.split(',').map(range).collect()
}

#[test]
fn the_formulas_have_a_face_of_their_own() {
    assert_none(&faults(&BOOK));
}

#[test]
fn a_letter_that_the_face_lacks_is_found() {
    let page = "step01_rays.html";
    let book = BOOK.with(page, "<mi>V</mi>", "<mi>Ж</mi>");
    assert_found(&faults(&book), &["'Ж'", page]);
}
