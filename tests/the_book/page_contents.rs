//! Pages tell the version, every picture is on one, and the fonts of the book have its letters.

use super::assert_no_faults;
use super::built_book::built_book;
use builder::inner_text;

#[test]
fn pages_tell_their_version() {
    let version = format!("Version {},", env!("CARGO_PKG_VERSION"));
    let template = include_str!("../../book/theme/index.hbs");
    assert!(template.contains(&version), "The footer has no {version}");
}

#[test]
fn every_picture_that_is_built_is_on_a_page() {
    let (book, mut faults) = (built_book(), vec![]);
    let chapters = book.chapters_in_order();
    let images = chapters.iter().flat_map(|page| page.select_all("img"));
    let sources: Vec<_> = images.filter_map(|img| img.attr("src")).collect();
    for file in book.files.0.keys().filter(|file| file.ends_with(".png")) {
        if !sources.contains(&file.as_str()) {
            faults.push(format!("{file} is on no page."));
        }
    }
    assert_no_faults(&faults);
}

/// Font families, and the elements whose letters must be in them; the empty name stands
/// for all families.
const FAMILIES: [(&str, &str); 3] =
    [("Course Math", "mi, mn, mo, mtext"), ("JetBrains Mono", "pre"), ("", "body")];

/// Letters that no font of the book has: those of the reader's machine draw them.
const LETTERS_OF_SYSTEM_FONTS: [char; 6] = ['ᵀ', 'ⁿ', 'ₛ', '○', '●', '\u{200b}'];

#[test]
fn fonts_have_the_letters_of_the_book() {
    let (book, mut faults) = (built_book(), vec![]);
    let css = book.files.text("fonts/fonts.css").expect("the fonts");
    for (family, selector) in FAMILIES {
        let ranges = unicode_ranges(css, family);
        let is_available = |c: char| {
            let code = u32::from(c);
            c.is_whitespace()
                || LETTERS_OF_SYSTEM_FONTS.contains(&c)
                || ranges.iter().any(|&[first, last]| (first..=last).contains(&code))
        };
        for page in book.pages.values() {
            for element in page.select_all(selector) {
                let text = inner_text(element);
                if let Some(c) = text.chars().find(|&c| !is_available(c)) {
                    let location = page.address_for_fault(element);
                    faults.push(format!("No font {family:?} has {c:?}, at {location}."));
                }
            }
        }
    }
    assert_no_faults(&faults);
}

/// The first and the last letter of each range for which the CSS declares a font whose
/// name begins with `family`.
fn unicode_ranges(css: &str, family: &str) -> Vec<[u32; 2]> {
    let name = format!("\"{family}");
    let fonts = css.lines().filter(|line| line.contains(&name));
    let lists = fonts.filter_map(|font| font.split_once("unicode-range:")?.1.split(';').next());
    let ranges = lists.flat_map(|ranges| ranges.split(','));
    let ranges = ranges.map(|range| range.trim().trim_start_matches("U+"));
    let ends = ranges.map(|range| range.split_once('-').unwrap_or((range, range)));
    let parse = |text| u32::from_str_radix(text, 16).expect("a hexadecimal number");
    ends.map(|(first, last)| [first, last].map(parse)).collect()
}
