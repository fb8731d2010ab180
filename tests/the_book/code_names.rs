//! Tests that the code contains every identifier that the chapters' text mentions. Otherwise, a
//! rename could leave the old identifier behind in the text.

use super::assert_no_faults;
use super::built_book::read_workspace_folder;
use super::source_listings::SOURCE_FILES;
use std::collections::HashSet;

/// Identifiers that the chapters mention, but that the reader's files don't contain. They come from
/// Rust, insta, OpenGL or Canvas.
const FOREIGN_NAMES: [&str; 7] =
    ["break", "f32", "ceil", "INSTA_UPDATE", "unseen", "gluPerspective", "LATE"];

/// Splits a text into words. Each item consists of the text before a word, the word, and the text
/// after the word.
fn words_with_surroundings(text: &str) -> impl Iterator<Item = (&str, &str, &str)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let words = text.split(move |c| !is_part(c)).filter(|word| !word.is_empty());
    words.map(|word| {
        let start = word.as_ptr() as usize - text.as_ptr() as usize;
        (&text[..start], word, &text[start + word.len()..])
    })
}

/// Whether a word in a code span has to be an identifier in the code. This is so if the word
///
/// - is the whole span,
/// - is written in `snake_case` or `CamelCase`,
/// - is called as a function, or
/// - is part of a path.
fn is_identifier_in_code_span(text_before: &str, word: &str, text_after: &str) -> bool {
    let mut pairs = word.chars().zip(word.chars().skip(1));
    word.starts_with(|c: char| c.is_alphabetic())
        && (text_before.is_empty() && text_after.is_empty()
            || word.contains('_')
            || pairs.any(|(a, b)| a.is_lowercase() && b.is_uppercase())
            || text_before.ends_with("::")
            || text_after.starts_with("::")
            || text_after.starts_with('('))
}

/// For each file whose code a reader types, returns the path and the code without comments.
fn reader_code_without_comments() -> Vec<(&'static str, String)> {
    let files = SOURCE_FILES.texts_with_suffix("").map(|(path, text)| {
        let lines = text.lines().map(|line| match line.split_once("//") {
            Some((code, _)) if path.ends_with(".rs") => code,
            _ => line,
        });
        (path, lines.collect::<Vec<_>>().join("\n"))
    });
    files.collect()
}

/// The names in the code that a reader types, and [`FOREIGN_NAMES`].
struct SourceNames<'a> {
    files: &'a [(&'static str, String)],
    /// All words in the code and in the paths.
    words: HashSet<&'a str>,
    /// The words that are directly followed by `(` or `<`, such as names of functions.
    called_words: HashSet<&'a str>,
}

impl<'a> SourceNames<'a> {
    fn in_files(files: &'a [(&'static str, String)]) -> Self {
        let words_in_code = || files.iter().flat_map(|(_, code)| words_with_surroundings(code));
        let called_words =
            words_in_code().filter(|(_, _, text_after)| text_after.starts_with(['(', '<']));
        let words_in_paths = files.iter().flat_map(|(path, _)| words_with_surroundings(path));
        Self {
            files,
            called_words: called_words.map(|(_, word, _)| word).chain(FOREIGN_NAMES).collect(),
            words: words_in_code()
                .chain(words_in_paths)
                .map(|(_, word, _)| word)
                .chain(FOREIGN_NAMES)
                .collect(),
        }
    }

    /// Whether the code contains `owner::name`, or whether a file that declares `owner` also
    /// contains `name`.
    fn has_path(&self, owner: &str, name: &str) -> bool {
        self.files.iter().any(|(_, code)| {
            let declares_owner = words_with_surroundings(code).any(|(text_before, word, _)| {
                let keywords = ["struct ", "enum ", "mod ", "impl ", "> "];
                word == owner && keywords.iter().any(|keyword| text_before.ends_with(keyword))
            });
            code.contains(&format!("{owner}::{name}"))
                || declares_owner && words_with_surroundings(code).any(|(_, word, _)| word == name)
        })
    }

    /// Whether the reader types a file with this name. `name` may also be the end of a path, such
    /// as `src/ray.rs`.
    fn has_file(&self, name: &str) -> bool {
        self.files.iter().any(|(path, _)| format!("/{path}").ends_with(&format!("/{name}")))
    }
}

/// Returns a sentence for each fault in a code span: an identifier that the code doesn't contain,
/// or a file that doesn't exist.
fn describe_name_faults(code_span: &str, source: &SourceNames) -> Vec<String> {
    let mut faults = vec![];
    for (text_before, word, text_after) in words_with_surroundings(code_span)
        .filter(|(b, word, a)| is_identifier_in_code_span(b, word, a))
    {
        if !source.words.contains(word) {
            faults.push(format!("`{word}` is not in the code"));
        } else if text_after.starts_with('(') && !source.called_words.contains(word) {
            faults.push(format!("`{word}` is not called or defined in the code"));
        }
        let owner = text_before
            .strip_suffix("::")
            .and_then(|text_before| words_with_surroundings(text_before).last());
        if let Some((_, owner, _)) = owner
            && !source.has_path(owner, word)
        {
            faults.push(format!("`{owner}::{word}` is not in the code"));
        }
    }
    if code_span.ends_with(".rs") && !code_span.contains(' ') && !source.has_file(code_span) {
        faults.push(format!("there is no file `{code_span}`"));
    }
    faults
}

#[test]
fn names_in_the_text_are_names_of_the_code() {
    let files = reader_code_without_comments();
    let source = SourceNames::in_files(&files);
    let mut faults = vec![];
    for (path, text) in read_workspace_folder("book/src").texts_with_suffix(".md") {
        let mut is_listing = false;
        for (line, number) in text.lines().zip(1..) {
            is_listing ^= line.starts_with("```");
            if is_listing {
                continue;
            }
            let codes = line.split('`').skip(1).step_by(2);
            let mut line_faults: Vec<_> =
                codes.flat_map(|code| describe_name_faults(code, &source)).collect();
            let test = line.strip_prefix("{{#by-hand ").and_then(|line| line.strip_suffix("}}"));
            if let Some(test) = test.filter(|test| !source.called_words.contains(test)) {
                line_faults.push(format!("there is no test `{test}`"));
            }
            let line_faults = line_faults.iter();
            faults.extend(line_faults.map(|fault| format!("book/src/{path}:{number}: {fault}.")));
        }
    }
    assert_no_faults(&faults);
}

#[test]
fn name_that_a_rename_left_behind_is_a_fault() {
    let code =
        "pub mod hits;\nimpl Ray {\n    pub fn at(self) -> f64 {\n        self.t\n    }\n}\n";
    let files = [("steps/src/ray.rs", code.to_owned())];
    let source = SourceNames::in_files(&files);
    for right in ["Ray", "Ray::at", "at(t)", "ray.at(2.0)", "hits", "ray.rs", "src/ray.rs", "2 + x"]
    {
        assert_eq!(describe_name_faults(right, &source), [""; 0], "{right}");
    }
    for wrong in ["Beam", "point", "Ray::point", "hits(ray)", "Ray::hits_of", "at::Ray", "hits.rs"]
    {
        assert_ne!(describe_name_faults(wrong, &source), [""; 0], "{wrong}");
    }
}
