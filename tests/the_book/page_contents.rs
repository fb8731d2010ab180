//! Directives and formulas are expanded, pictures and drawings have a text for those who
//! can't see them, and the fonts of the book have its letters.

use super::assert_no_faults;
use super::built_book::built_book;
use builder::{inner_text, select_all};

/// Text that is on a page only if a directive or a formula was not expanded.
const UNEXPANDED_MARKS: [&str; 4] = ["{{#", "$$", r"\frac", r"\begin{"];

#[test]
fn directives_and_formulas_are_expanded() {
    let (book, mut faults) = (built_book(), vec![]);
    for page in book.pages.values() {
        let body: String = page.select_all("body").into_iter().map(inner_text).collect();
        let marks = UNEXPANDED_MARKS.iter().filter(|mark| body.contains(**mark));
        faults.extend(marks.map(|mark| format!("{mark} is left in {}.", page.name)));
    }
    assert_no_faults(&faults);
}

#[test]
fn pages_tell_their_version() {
    let version = format!("Version {},", env!("CARGO_PKG_VERSION"));
    let is_chapter = |page: &&builder::Page| page.name != "toc.html";
    let mut faults = vec![];
    for page in built_book().pages.values().filter(is_chapter) {
        let footer: String = page.select_all("footer").into_iter().map(inner_text).collect();
        if !footer.contains(&version) {
            faults.push(format!("{} does not say {version}", page.name));
        }
    }
    assert_no_faults(&faults);
}

#[test]
fn pictures_and_drawings_have_a_text() {
    let (book, mut faults) = (built_book(), vec![]);
    for page in book.pages.values() {
        for img in page.select_all("img:not([role=img] > img)") {
            if img.attr("alt").is_none_or(|alt| alt.trim().is_empty()) {
                faults.push(format!("The picture at {} has no alt.", page.address_for_fault(img)));
            }
        }
        for svg in page.select_all("figure svg") {
            let titles = select_all(svg, "title");
            if titles.iter().all(|title| inner_text(*title).trim().is_empty()) {
                faults
                    .push(format!("The drawing at {} has no title.", page.address_for_fault(svg)));
            }
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
    let ranges = fonts.filter_map(|font| font.split_once("unicode-range:"));
    let ranges = ranges.flat_map(|(_, ranges)| ranges.split(';').next());
    let ranges = ranges.flat_map(|ranges| ranges.split(','));
    let parse = |text| u32::from_str_radix(text, 16).expect("a hexadecimal number");
    ranges
        .map(|range| {
            let range = range.trim().trim_start_matches("U+");
            let (first, last) = range.split_once('-').unwrap_or((range, range));
            [parse(first), parse(last)]
        })
        .collect()
}
