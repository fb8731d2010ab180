//! A name in the text of a chapter is one of the code: what is renamed there is renamed here.

use super::assert_no_faults;
use super::built_book::read_folder;
use super::source_listings::SOURCE_FILES;
use std::collections::HashSet;

/// Names that are in no file of the steps: of Rust's standard, of insta, of OpenGL.
const FOREIGN_NAMES: [&str; 3] = ["ceil", "INSTA_UPDATE", "gluPerspective"];

/// The words of a text, each with what is before and after it.
fn words(text: &str) -> impl Iterator<Item = (&str, &str, &str)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let words = text.split(move |c| !is_part(c)).filter(|word| !word.is_empty());
    words.map(|word| {
        let start = word.as_ptr() as usize - text.as_ptr() as usize;
        (&text[..start], word, &text[start + word.len()..])
    })
}

/// Whether a word in code is a name: `snake_case`, `CamelCase`, called, or part of a path.
fn is_name(before: &str, word: &str, after: &str) -> bool {
    let mut pairs = word.chars().zip(word.chars().skip(1));
    word.starts_with(|c: char| c.is_alphabetic())
        && (word.contains('_')
            || pairs.any(|(a, b)| a.is_lowercase() && b.is_uppercase())
            || before.ends_with("::")
            || after.starts_with("::")
            || after.starts_with('('))
}

#[test]
fn names_in_the_text_are_names_of_the_code() {
    let files = SOURCE_FILES.texts_with_suffix("").flat_map(|(path, text)| [path, text]);
    let mut names: HashSet<_> = files.flat_map(words).map(|(_, word, _)| word).collect();
    names.extend(FOREIGN_NAMES);
    let mut faults = vec![];
    for (path, text) in read_folder("book/src").texts_with_suffix(".md") {
        let mut is_listing = false;
        for (line, number) in text.lines().zip(1..) {
            is_listing ^= line.starts_with("```");
            let codes = line.split('`').skip(1).step_by(2).filter(|_| !is_listing);
            let codes = codes.chain(line.strip_prefix("{{#by-hand "));
            for (before, word, after) in codes.flat_map(words) {
                if is_name(before, word, after) && !names.contains(word) {
                    faults.push(format!("book/src/{path}:{number}: no code has `{word}`."));
                }
            }
        }
    }
    assert_no_faults(&faults);
}
