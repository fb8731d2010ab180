//! Notes. In a chapter, a note follows a block. On the page, the note is in the margin beside that
//! block.

use crate::directive::{Directive, DirectiveKind};
use crate::fault::ChapterResult;
use crate::markdown::{self, html_block};
use crate::values::Values;
use mdbook_markdown::pulldown_cmark::{Event, Tag};
use std::ops::Range;

/// Returns the opening HTML of a wrapper. The wrapper contains a block, the block's notes, and any
/// tool that appears beside the block.
pub fn wrapper_opening_html() -> String {
    html_block("<div class=\"with-margin\">")
}

/// Returns the closing HTML of the wrapper that [`wrapper_opening_html`] begins.
pub fn wrapper_closing_html() -> String {
    html_block("</div>")
}

/// The kinds of notes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoteKind {
    /// A remark by the author.
    Note,
    /// An explanation of some Rust.
    Rust,
    /// The name of the test that verifies numbers worked out by hand.
    ByHand,
}

/// Returns the HTML of a note: `{{#note words}}`, `{{#rust words}}` or `{{#by-hand test}}`.
pub fn note_html(kind: NoteKind, words: &str, values: &Values) -> ChapterResult<String> {
    let (class, label) = match kind {
        NoteKind::Note => ("note", ""),
        NoteKind::Rust => ("note rust", "<strong>New Rust here</strong> "),
        NoteKind::ByHand => {
            let name = markdown::code_with_break_hints(words);
            return Ok(format!("<p class=\"by-hand\" role=\"note\">Test: {name}</p>\n"));
        }
    };
    let words = markdown::inline_html(words, values)?;
    Ok(format!("<aside class=\"{class}\" role=\"note\">{label}{words}</aside>\n"))
}

/// Finds the blocks that have notes. For each such block, returns one range that covers the block
/// and the notes after it. Headings, HTML, and directives that begin or end a box can't have notes.
pub fn find_noted_blocks(text: &str, events: &[(Event, Range<usize>)]) -> Vec<Range<usize>> {
    let mut noted: Vec<Range<usize>> = vec![];
    // A range that covers the last block and the notes found after it so far. None if no note may
    // follow that block.
    let mut block: Option<Range<usize>> = None;
    let mut nesting = 0;
    for (event, range) in events {
        match event {
            Event::Start(tag) => {
                nesting += 1;
                if nesting > 1 {
                    continue;
                }
                let directive = Directive::parse(&text[range.clone()]);
                let kind =
                    directive.filter(|_| *tag == Tag::Paragraph).map(|directive| directive.kind);
                if !matches!(kind, Some(DirectiveKind::Note(_))) {
                    block = can_be_followed_by_notes(tag, kind).then(|| range.clone());
                } else if let Some(block) = &mut block {
                    noted.pop_if(|last| last.start == block.start);
                    block.end = range.end;
                    noted.push(block.clone());
                }
            }
            Event::End(_) => nesting -= 1,
            _ if nesting == 0 => block = None,
            _ => {}
        }
    }
    noted
}

/// Whether notes may follow a block. If the block is a paragraph that consists of a single
/// directive, `kind` is that directive's kind.
fn can_be_followed_by_notes(tag: &Tag, kind: Option<DirectiveKind>) -> bool {
    use DirectiveKind::{Check, Figure, Number, Value};
    match tag {
        Tag::Paragraph => matches!(kind, None | Some(Figure | Check | Value | Number)),
        Tag::List(_) | Tag::Table(_) | Tag::CodeBlock(_) | Tag::BlockQuote(_) => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdbook_markdown::pulldown_cmark::Parser;

    /// The blocks in a chapter that have notes, together with their notes.
    fn noted_blocks(text: &str) -> Vec<&str> {
        let parser = Parser::new_ext(text, markdown::markdown_options());
        let events: Vec<_> = parser.into_offset_iter().collect();
        let ranges = find_noted_blocks(text, &events).into_iter();
        ranges.map(|range| text[range].trim_end()).collect()
    }

    #[test]
    fn notes_belong_to_the_block_before_them() {
        let two = "A.\n\n{{#note B.}}\n\n{{#by-hand c}}";
        let list = "- D\n\n  E\n\n{{#rust F.}}";
        let listing = "```rust\n# G\n```\n{{#note\nH.}}";
        let text = format!("{two}\n\nText.\n\n{list}\n\n{listing}\n");
        assert_eq!(noted_blocks(&text), [two, list, listing]);
    }

    #[test]
    fn note_without_a_block_before_it_belongs_to_none() {
        for text in [
            "{{#note A.}}",
            "# A\n\n{{#note B.}}",
            "A.\n\n</div>\n\n{{#note B.}}",
            "A.\n\n---\n\n{{#note B.}}",
            "{{#predict A?}}\n\n{{#note B.}}",
            "A.\n\n{{#end}}\n\n{{#note B.}}",
            "> {{#note A.}}",
        ] {
            assert_eq!(noted_blocks(text), [""; 0], "{text}");
        }
    }
}
