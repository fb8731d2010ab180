//! The chapters keep the rules of style: calm words.

use super::built::files;
use super::{assert_found, assert_none};
use book::Files;
use mdbook_markdown::pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::sync::LazyLock;

/// Words that tell a reader who does not see it at once that the fault is theirs.
const WORDS: [&str; 3] = ["simply", "just", "obviously"];

static CHAPTERS: LazyLock<Files> = LazyLock::new(|| {
    let mut files = files("book/chapters");
    files.0.retain(|path, _| path.ends_with(".md"));
    files
});

/// Each line of a chapter that breaks a rule.
fn faults(chapters: &Files) -> Vec<String> {
    let mut faults = vec![];
    for (path, markdown) in chapters.texts("") {
        for (at, what) in broken(markdown) {
            let line = 1 + markdown[..at].matches('\n').count();
            faults.push(format!("Line {line} of book/chapters/{path} has {what}."));
        }
    }
    faults
}

/// Where a rule is broken in a chapter, and by what.
fn broken(markdown: &str) -> Vec<(usize, String)> {
    let options =
        Options::ENABLE_MATH | Options::ENABLE_GFM | Options::ENABLE_TABLES;
    let mut broken = vec![];
    let mut not_ours = 0;
    for (event, range) in Parser::new_ext(markdown, options).into_offset_iter() {
        let prose = match &event {
            // A plain quote is a slide's words, not ours.
            Event::Start(Tag::BlockQuote(None) | Tag::CodeBlock(_)) => {
                not_ours += 1;
                continue;
            }
            Event::End(TagEnd::BlockQuote(None) | TagEnd::CodeBlock) => {
                not_ours -= 1;
                continue;
            }
            Event::Start(Tag::Image { title, .. }) => title,
            Event::Text(text) if not_ours == 0 => text,
            _ => continue,
        };
        broken.extend(wrong_words(prose).map(|what| (range.start, what)));
    }
    broken
}

/// What should not be in a piece of prose.
fn wrong_words(text: &str) -> impl Iterator<Item = String> {
    let words = text.split(|c: char| !c.is_alphanumeric());
    let wrong = words.filter(|word| WORDS.contains(&word.to_lowercase().as_str()));
    let wrong = wrong.map(|word| format!("the word {word:?}"));
    wrong
        .chain(text.contains('!').then(|| format!("an exclamation mark: {text:?}")))
}

#[test]
fn every_chapter_keeps_the_rules() {
    assert_none(&faults(&CHAPTERS));
}

#[test]
fn what_breaks_a_rule_is_found() {
    for (text, what) in [
        ("It is *simply* a sum.", "\"simply\""),
        ("> [!NOTE]\n> Just so.", "\"Just\""),
        ("| A |\n| --- |\n| obviously |", "\"obviously\""),
        ("That is it!", "exclamation"),
        ("![What a view](pictures/cover.png \"Look!\")", "exclamation"),
    ] {
        let title = "# Step 1: rays";
        let chapters =
            CHAPTERS.with("step01_rays.md", title, &format!("{title}\n\n{text}"));
        let found = faults(&chapters);
        assert_found(&found, &["Line ", "book/chapters/step01_rays.md", what]);
    }
}

#[test]
fn code_formulas_and_quotes_may_have_them() {
    let allowed =
        "Not `just!`, nor $n!$.\n\n> It is just a vector!\n\n![A ray](a.png)\n";
    assert_eq!(broken(allowed), []);
}
