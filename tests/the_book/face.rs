//! The faces of the book have its letters.

use super::built::BOOK;
use super::{assert_found, assert_none};
use book::Site;

/// What is drawn in each face; what stands in none of these may be in any.
const FACES: [(&str, &[&str]); 2] =
    [("Course Math", &["mi", "mn", "mo", "mtext"]), ("JetBrains Mono", &["pre"])];

/// Signs that are left to the faces of the reader's machine.
const ANYWHERE: [char; 6] = ['ᵀ', 'ⁿ', 'ₛ', '○', '●', '\u{200b}'];

/// Each letter of a formula or a listing that its face lacks, and each that no face has.
fn faults(book: &Site) -> Vec<String> {
    let css = book.files.text("fonts/fonts.css").unwrap_or_default();
    let mut faults = vec![];
    let any = ranges(css, "");
    for page in book.pages.values() {
        if let Some(c) = missing(&page.text, &any) {
            faults.push(format!(
                "No face has {c:?} ({:X}), in {}.",
                c as u32, page.name
            ));
        }
        for (family, tags) in FACES {
            let its = ranges(css, family);
            for element in tags.iter().flat_map(|tag| page.all(tag)) {
                if let Some(c) = missing(&element.text, &its) {
                    faults.push(format!(
                        "{family} has no {c:?} ({:X}), at {}.",
                        c as u32,
                        page.at(element)
                    ));
                }
            }
        }
    }
    faults
}

/// The first letter of the text that none of the ranges holds.
fn missing(text: &str, ranges: &[[u32; 2]]) -> Option<char> {
    let has =
        |c: char| ranges.iter().any(|[a, b]| (*a..=*b).contains(&u32::from(c)));
    let mut drawn =
        text.chars().filter(|c| !c.is_whitespace() && !ANYWHERE.contains(c));
    drawn.find(|&c| !has(c))
}

/// The first and the last of the letters in a row that the faces of a family have.
fn ranges(css: &str, family: &str) -> Vec<[u32; 2]> {
    let number = |text: &str| u32::from_str_radix(text, 16).expect("a letter");
    let range = |text: &str| {
        let text = text.trim().trim_start_matches("U+");
        let (a, b) = text.split_once('-').unwrap_or((text, text));
        [number(a), number(b)]
    };
    let faces = css.lines().filter(|line| line.contains(&format!("\"{family}")));
    let named = faces
        .filter_map(|face| face.split_once("unicode-range:")?.1.split(';').next());
    named.flat_map(|all| all.split(',').map(range)).collect()
}

#[test]
fn each_letter_has_its_face() {
    assert_none(&faults(&BOOK));
}

#[test]
fn a_letter_that_a_face_lacks_is_found() {
    let page = "step01_rays.html";
    for (from, to, family) in [
        ("<mi>V</mi>", "<mi>é</mi>", "Course Math"),
        ("<pre><code", "<pre>⟂<code", "JetBrains Mono"),
        ("<p>", "<p>Ж", "No face"),
    ] {
        let found = faults(&BOOK.with(page, from, to));
        assert_found(&found, &[family, page]);
    }
}
