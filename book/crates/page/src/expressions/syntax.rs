//! Parses a line with `syn`, and explains in plain words what `syn` can't parse.

use crate::expressions::refusal::{Fault, Refusal, refuse};
use std::ops::Range;
use syn::Expr;

/// The maximum length of a line, in bytes. However deeply such a line is nested, it can't overflow
/// a page's stack.
const MAX_LENGTH: usize = 250;

/// Parses a line as an expression.
pub fn parse_syntax(text: &str) -> Result<Expr, Refusal> {
    check_signs(text)?;
    // Otherwise, every line ever parsed would stay in memory.
    proc_macro2::extra::invalidate_current_thread_spans();
    syn::parse_str(text).map_err(|error| {
        let range = error.span().byte_range();
        explain_syntax_error(text, range, &error.to_string())
    })
}

/// Refuses characters that no line may contain, and lines that are too long.
fn check_signs(text: &str) -> Result<(), Refusal> {
    if text.len() > MAX_LENGTH {
        return refuse(0..text.len(), Fault::LongText);
    }
    let is_hidden = |sign: char| sign.is_control() && !"\n\t".contains(sign);
    if let Some((at, sign)) = text.char_indices().find(|(_, sign)| is_hidden(*sign)) {
        return refuse(at..at + sign.len_utf8(), Fault::ControlCharacter);
    }
    let is_unreadable = |sign: char| !sign.is_ascii() || "'\"#@$\\".contains(sign);
    if let Some((at, sign)) = text.char_indices().find(|(_, sign)| is_unreadable(*sign)) {
        return refuse(at..at + sign.len_utf8(), Fault::UnreadableSign(sign));
    }
    let signs = [("//", Fault::LineComment), ("<-", Fault::LeftArrow), ("?", Fault::QuestionMark)];
    for (sign, fault) in signs {
        if let Some(at) = text.find(sign) {
            return refuse(at..at + sign.len(), fault);
        }
    }
    Ok(())
}

/// Explains in plain words why `syn` stopped at this range.
fn explain_syntax_error(text: &str, range: Range<usize>, error: &str) -> Refusal {
    let end = text.trim_end().len();
    let at = range.start;
    let is_at_end = range.is_empty() || at >= end;
    if end == 0 {
        return Refusal { range: 0..0, fault: Fault::Nothing };
    }
    let (range, fault) = if error.contains("token stream") {
        let fault = match text[at..].chars().next() {
            Some('(' | '[' | '{') => Fault::UnclosedBracket,
            Some(')' | ']' | '}') => Fault::UnopenedBracket,
            _ => Fault::Unreadable,
        };
        (at..text.len().min(at + 1), fault)
    } else if error.contains("chained") {
        (range, Fault::ComparisonChain)
    } else if &text[range.clone()] == ";" {
        (range, Fault::Statement)
    } else if is_at_end {
        (end - 1..end, Fault::MissingBehind)
    } else {
        (range, Fault::MissingBefore)
    };
    Refusal { range, fault }
}
