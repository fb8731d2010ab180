//! The fonts of the book have its letters.

use super::assert_no_faults;
use super::built_book::built_book;
use builder::inner_text;
use std::ops::RangeInclusive;

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
        let is_missing = |c: &char| {
            let is_drawn = ranges.iter().any(|range| range.contains(&u32::from(*c)));
            !is_drawn && !c.is_whitespace() && !LETTERS_OF_SYSTEM_FONTS.contains(c)
        };
        for page in book.pages.values() {
            for element in page.select_all(selector) {
                if let Some(c) = inner_text(element).chars().find(is_missing) {
                    let location = page.address_for_fault(element);
                    faults.push(format!("No font {family:?} has {c:?}, at {location}."));
                }
            }
        }
    }
    assert_no_faults(&faults);
}

/// The ranges of letters for which the CSS declares a font whose name begins with `family`.
fn unicode_ranges(css: &str, family: &str) -> Vec<RangeInclusive<u32>> {
    let name = format!("\"{family}");
    let fonts = css.lines().filter(|line| line.contains(&name));
    let lists = fonts.filter_map(|font| font.split_once("unicode-range:")?.1.split(';').next());
    let ranges = lists.flat_map(|ranges| ranges.split(','));
    let ranges = ranges.map(|range| range.trim().trim_start_matches("U+"));
    let ends = ranges.map(|range| range.split_once('-').unwrap_or((range, range)));
    let parse = |text| u32::from_str_radix(text, 16).expect("a hexadecimal number");
    ends.map(|(first, last)| parse(first)..=parse(last)).collect()
}
