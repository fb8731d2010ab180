use crate::expressions::refusal::{Refusal, refuse};
use std::ops::Range;
use syn::Expr;

/// The most bytes of a text, and the most words and signs: as deep as they may be inside each
/// other, they fit the stack of a page.
const LENGTH: usize = 400;
const TOKENS: usize = 200;

/// The most brackets inside each other.
const DEPTH: usize = 20;

const STATEMENTS: &str = "Statements need a block around them: { let x = 1.0; 2.0 * x }.";

/// Signs that no line may have, each with a sentence about it.
const SIGNS: [(&str, &str); 12] = [
    ("<-", "Rust reads <- as one sign: put a blank after the <."),
    ("×", "For ×, Rust has *."),
    ("·", "For ·, Rust has * between numbers, and a.dot(b) between vectors."),
    ("÷", "For ÷, Rust has /."),
    ("−", "For −, Rust has -."),
    ("²", "For ², Rust has .powi(2)."),
    ("³", "For ³, Rust has .powi(3)."),
    ("√", "For √, Rust has .sqrt()."),
    ("≤", "For ≤, Rust has <=."),
    ("≥", "For ≥, Rust has >=."),
    ("π", "For π, Rust has std::f64::consts::PI."),
    ("?", "For ? :, Rust has if … { … } else { … }."),
];

/// The expression that a text without comments is, if it is one.
pub fn parse_syntax(text: &str) -> Result<Expr, Refusal> {
    // Otherwise each text that is read stays in memory.
    proc_macro2::extra::invalidate_current_thread_spans();
    syn::parse_str(text).map_err(|error| {
        let range = error.span().byte_range();
        explain_syntax_error(text, range, &error.to_string())
    })
}

/// The text with blanks for its comments. Refuses brackets that don't match, signs that no line
/// has, and what is too long or too deep to be read.
pub fn blank_comments(text: &str) -> Result<String, Refusal> {
    if LENGTH < text.len() {
        return refuse(0..text.len(), "That's longer than a line should be.");
    }
    let mut bare = String::new();
    let (mut brackets, mut at, mut tokens, mut is_in_word) = (vec![], 0, 0, false);
    while let Some(sign) = text[at..].chars().next() {
        let (remaining, range) = (&text[at..], at..at + sign.len_utf8());
        at = range.end;
        let ends = [("//", "\n"), ("/*", "*/")];
        if let Some((_, end)) = ends.into_iter().find(|(sign, _)| remaining.starts_with(sign)) {
            let Some(length) = remaining[2..].find(end) else {
                let sentence = "This comment hides the rest of the line: write /* … */.";
                return refuse(range.start..text.len(), sentence);
            };
            at = range.start + 2 + length + end.len();
            bare += &" ".repeat(at - range.start);
            continue;
        }
        if let Some((sign, sentence)) = SIGNS.iter().find(|(sign, _)| remaining.starts_with(sign)) {
            return refuse(range.start..range.start + sign.len(), *sentence);
        }
        if "'\"#@$\\".contains(sign) {
            return refuse(range, "No line that a page draws has this sign.");
        }
        let is_word = sign.is_alphanumeric() || sign == '_';
        tokens += usize::from(!(sign.is_whitespace() || is_word && is_in_word));
        is_in_word = is_word;
        bare.push(sign);
        match sign {
            '(' => brackets.push((range, ')')),
            '[' => brackets.push((range, ']')),
            '{' => brackets.push((range, '}')),
            ')' | ']' | '}' if brackets.pop().is_none_or(|(_, closing)| closing != sign) => {
                return refuse(range, format!("This {sign} closes nothing."));
            }
            ';' if brackets.is_empty() => return refuse(range, STATEMENTS),
            _ => {}
        }
        if DEPTH < brackets.len() {
            return refuse(at - 1..at, "That's too many inside each other.");
        }
    }
    match brackets.pop() {
        Some((range, closing)) => refuse(range, format!("The {closing} for this is missing.")),
        None if TOKENS < tokens => refuse(0..text.len(), "That's more than a line should have."),
        None => Ok(bare),
    }
}

/// Explains in plain words why `syn` ended there.
fn explain_syntax_error(text: &str, range: Range<usize>, error: &str) -> Refusal {
    let end = text.trim_end().len();
    let last = text[..end].char_indices().next_back().map_or(0..0, |(at, _)| at..end);
    let is_end = range.is_empty() || last.end <= range.start;
    let (range, sentence) = match &text[range.clone()] {
        _ if end == 0 => (0..0, "Write a value here. Reset brings back the book’s."),
        _ if is_end => (last, "A value is missing behind this."),
        _ if error.contains("chained") => (range, "Rust compares two at a time: a < b && b < c."),
        ")" | "]" | "}" => (range, "A value is missing before this."),
        "=" => (range, "For =, Rust has == to compare."),
        _ if error.contains("an expression") => {
            (range, "A number, a name or a ( is missing before this.")
        }
        _ => (range, "Something is missing before this, such as * or +."),
    };
    Refusal { range, sentence: sentence.to_owned() }
}
