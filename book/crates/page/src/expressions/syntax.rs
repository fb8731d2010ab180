//! Parses a line with `syn`, and explains in plain words what `syn` can't parse.

use crate::expressions::refusal::{Fault, Refusal, refuse};
use course::{Place, PlaceNote};
use proc_macro2::TokenStream;
use std::ops::Range;
use syn::parse::Parser;
use syn::{Block, Stmt};

/// The error message of `syn` for `a < b < c`. We recognise this error by its message, because the
/// errors of `syn` have no kinds. Without the message, we would need our own parser to distinguish
/// `a < b < c` from `a < < c`. If `syn` ever changes the message, the test
/// `chain_of_comparisons_is_recognised` fails.
const COMPARISON_CHAIN: &str = "comparison operators cannot be chained";

/// The maximum length of a line, in bytes. A line of this length can't overflow a page's stack,
/// however deeply it is nested.
const MAX_LENGTH: usize = 250;

/// Parses a line, which has to be an expression. At the end of a block, the line may also consist
/// of statements followed by a value.
pub fn parse_syntax(place: &Place, text: &str) -> Result<Vec<Stmt>, Refusal> {
    let has_note = |note| place.notes.contains(&note);
    let ends_block = has_note(PlaceNote::EndsBlock);
    refuse_unreadable_text(text, ends_block || has_note(PlaceNote::EndsLine))?;
    // Free the lines parsed so far, because proc_macro2 would keep them in memory.
    proc_macro2::extra::invalidate_current_thread_spans();
    let error = match syn::parse_str(text) {
        Ok(syntax) => return Ok(vec![Stmt::Expr(syntax, None)]),
        Err(error) => error,
    };
    let refusal = explain_syntax_error(text, error.span().byte_range(), &error.to_string());
    if ends_block
        && refusal.fault == Fault::Statement
        && let Ok(statements) = Block::parse_within.parse_str(text)
    {
        return Ok(statements);
    }
    Err(refusal)
}

/// Returns where a `//` comment begins in the last row of the text, if the row has one. In the
/// listing, such a comment would hide the code that follows the text.
fn find_line_comment_in_last_row(text: &str) -> Option<usize> {
    let (mut depth, mut index) = (0, 0);
    while index < text.len() {
        let remaining_bytes = &text.as_bytes()[index..];
        if depth == 0 && remaining_bytes.starts_with(b"//") {
            match text[index..].find('\n') {
                Some(length) => index += length,
                None => return Some(index),
            }
        } else if remaining_bytes.starts_with(b"/*") {
            (depth, index) = (depth + 1, index + 2);
        } else if depth > 0 && remaining_bytes.starts_with(b"*/") {
            (depth, index) = (depth - 1, index + 2);
        } else {
            index += 1;
        }
    }
    None
}

/// Refuses a text that is too long, or that contains something that no line may contain, such as a
/// quotation mark or a `?`. Unless `allows_line_comment` is true, also refuses a `//` comment in
/// the last row.
fn refuse_unreadable_text(text: &str, allows_line_comment: bool) -> Result<(), Refusal> {
    if text.len() > MAX_LENGTH {
        return refuse(0..text.len(), Fault::LongText);
    }
    let is_hidden = |character: char| character.is_control() && !"\n\t".contains(character);
    if let Some((start, character)) =
        text.char_indices().find(|(_, character)| is_hidden(*character))
    {
        return refuse(start..start + character.len_utf8(), Fault::ControlCharacter);
    }
    let is_unreadable = |character: char| !character.is_ascii() || "'\"#@$\\".contains(character);
    if let Some((start, character)) =
        text.char_indices().find(|(_, character)| is_unreadable(*character))
    {
        return refuse(start..start + character.len_utf8(), Fault::UnreadableCharacter(character));
    }
    if let Some(start) = find_line_comment_in_last_row(text).filter(|_| !allows_line_comment) {
        return refuse(start..start + 2, Fault::LineComment);
    }
    for (symbol, fault) in [("<-", Fault::LeftArrow), ("?", Fault::QuestionMark)] {
        if let Some(start) = text.find(symbol) {
            return refuse(start..start + symbol.len(), fault);
        }
    }
    Ok(())
}

/// Explains in plain words why `syn` stopped at this range.
fn explain_syntax_error(text: &str, range: Range<usize>, error: &str) -> Refusal {
    let end = text.trim_end().len();
    let start = range.start;
    let is_at_end = range.is_empty() || start >= end;
    if end == 0 {
        return Refusal { range: 0..0, fault: Fault::Nothing };
    }
    let (range, fault) = if text.parse::<TokenStream>().is_err() {
        let fault = match text[start..].chars().next() {
            Some('(' | '[' | '{') => Fault::UnclosedBracket,
            Some(')' | ']' | '}') => Fault::UnopenedBracket,
            _ => Fault::Unreadable,
        };
        (start..text.len().min(start + 1), fault)
    } else if error == COMPARISON_CHAIN {
        (range, Fault::ComparisonChain)
    } else if &text[range.clone()] == ";" {
        let has_let = text.trim_start().starts_with("let ");
        let fault = match range.end < end {
            true if has_let => Fault::Statement,
            true => Fault::TwoStatements,
            false => Fault::Semicolon,
        };
        (range, fault)
    } else if is_at_end {
        (end - 1..end, Fault::MissingAfter)
    } else {
        (range, Fault::MissingBefore)
    };
    Refusal { range, fault }
}

#[cfg(test)]
mod tests {
    use super::*;
    use syn::Expr;

    /// Explains the syntax error in this text.
    fn explain(text: &str) -> (Range<usize>, Fault) {
        let error = syn::parse_str::<Expr>(text).err().expect("a fault");
        let Refusal { range, fault } =
            explain_syntax_error(text, error.span().byte_range(), &error.to_string());
        (range, fault)
    }

    #[test]
    fn chain_of_comparisons_is_recognised() {
        assert_eq!(explain("a < b < c").1, Fault::ComparisonChain);
        assert_eq!(explain("a == b == c").1, Fault::ComparisonChain);
        assert_eq!(explain("a == == c").1, Fault::MissingBefore);
    }

    #[test]
    fn lexical_errors_are_distinguished_from_syntax_errors() {
        assert_eq!(explain("a * (b + c"), (4..5, Fault::UnclosedBracket));
        assert_eq!(explain("a) * b"), (1..2, Fault::UnopenedBracket));
        assert_eq!(explain("a * /* b"), (4..5, Fault::Unreadable));
        assert_eq!(explain("a * / b"), (4..5, Fault::MissingBefore));
        assert_eq!(explain("a *"), (2..3, Fault::MissingAfter));
    }

    #[test]
    fn comment_in_the_last_row_is_found() {
        for (text, start) in [
            ("a // b", Some(2)),
            ("a // b\n + c", None),
            ("a // b\n + c //", Some(12)),
            ("a /* // */ + b", None),
            ("a /* /* */ // */ + b", None),
            ("a /* */ // b", Some(8)),
            ("a / b", None),
        ] {
            assert_eq!(find_line_comment_in_last_row(text), start, "{text}");
        }
    }
}
