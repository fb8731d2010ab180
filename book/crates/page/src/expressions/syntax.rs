use crate::expressions::refusal::{Checked, Refusal, refuse};
use std::ops::Range;
use syn::Expr;

/// The most bytes: as deep as they may be inside each other, they fit the stack of a page.
const LENGTH: usize = 250;

/// Signs that no line may have, each with a sentence about it.
const UNREAD_SIGNS: [(&str, &str); 3] = [
    ("//", "This comment hides the rest of the line: write /* … */."),
    ("<-", "Rust reads <- as one sign: put a blank after the <."),
    ("?", "For ? :, Rust has if … { … } else { … }."),
];

/// The expression that a text is, if it is one.
pub fn parse_syntax(text: &str) -> Checked<Expr> {
    check_signs(text)?;
    // Otherwise each text that is read stays in memory.
    proc_macro2::extra::invalidate_current_thread_spans();
    syn::parse_str(text).map_err(|error| {
        let range = error.span().byte_range();
        explain_syntax_error(text, range, &error.to_string())
    })
}

/// Refuses signs that no line has, and what is too long to be read.
fn check_signs(text: &str) -> Checked<()> {
    if LENGTH < text.len() {
        return refuse(0..text.len(), "That's longer than a line should be.");
    }
    let is_hidden = |sign: char| sign.is_control() && !"\n\t".contains(sign);
    if let Some((at, sign)) = text.char_indices().find(|(_, sign)| is_hidden(*sign)) {
        return refuse(at..at + sign.len_utf8(), "A control character is here, which nobody sees.");
    }
    let is_unread = |sign: char| !sign.is_ascii() || "'\"#@$\\".contains(sign);
    if let Some((at, sign)) = text.char_indices().find(|(_, sign)| is_unread(*sign)) {
        let sentence = format!(
            "A page can't read {sign}. Rust has a * b, a.dot(b), a / b, a - b, .powi(2), .sqrt(), \
             <=, std::f64::consts::PI."
        );
        return refuse(at..at + 1, sentence);
    }
    let find = |(sign, sentence)| Some((text.match_indices(sign).next()?, sentence));
    match UNREAD_SIGNS.into_iter().find_map(find) {
        Some(((at, sign), sentence)) => refuse(at..at + sign.len(), sentence),
        None => Ok(()),
    }
}

/// Explains in plain words why `syn` ended there.
fn explain_syntax_error(text: &str, range: Range<usize>, error: &str) -> Refusal {
    let end = text.trim_end().len();
    let is_end = range.is_empty() || end <= range.start;
    let at = range.start;
    let (range, sentence) = match (&text[range.clone()], text[at..].chars().next()) {
        _ if end == 0 => (0..0, "Write a value here. Reset brings back the book’s."),
        (_, sign) if error.contains("token stream") => {
            let sentence = match sign {
                Some('(' | '[' | '{') => "The bracket that closes this one is missing.",
                Some(')' | ']' | '}') => "This closes nothing.",
                _ => "Rust can't read on from here.",
            };
            (at..text.len().min(at + 1), sentence)
        }
        _ if error.contains("chained") => (range, "Rust compares two at a time: a < b && b < c."),
        (";", _) => (range, "Statements need a block: { let x = 1.0; 2.0 * x }."),
        _ if is_end => (end - 1..end, "A value is missing behind this."),
        _ => (range, "Something is missing before this, such as a value, * or +."),
    };
    Refusal { range, sentence: sentence.to_owned() }
}
