use crate::fault::{ChapterError, ChapterResult};
use crate::numbers;
use math_core::{LatexToMathML, MathDisplay};
use std::thread;

/// Commands and braces that a formula may have: the parser takes up to 60 kB of the stack for
/// each that is inside another.
const MAX_MARKS: usize = 100;
const STACK_BYTES: usize = 16 << 20;

/// The MathML of a formula in LaTeX, safe to stand in a line of Markdown.
pub fn formula_html(latex: &str, is_display: bool) -> ChapterResult<String> {
    let style = if is_display { MathDisplay::Block } else { MathDisplay::Inline };
    let mathml = numbers::fill_in_formula(latex, |latex| convert(latex, style))?;
    let mathml = escape_markdown(&mathml);
    Ok(if is_display {
        format!(r#"<span class="formula" tabindex="0">{mathml}</span>"#)
    } else {
        mathml
    })
}

/// The MathML of a formula without numbers that are still to be filled in.
fn convert(latex: &str, style: MathDisplay) -> ChapterResult<String> {
    let latex = latex.trim();
    if MAX_MARKS < latex.matches(['\\', '{']).count() {
        return Err(ChapterError::LongFormula(MAX_MARKS));
    }
    let convert = || LatexToMathML::default().convert_with_local_state(latex, style);
    let converted = thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, convert);
        thread.ok()?.join().ok()
    });
    let formula_error = |source| ChapterError::Formula { latex: latex.to_owned(), source };
    match converted {
        Some(Ok(converted)) => Ok(converted.mathml),
        Some(Err(error)) => Err(formula_error(Some(error))),
        None => Err(formula_error(None)),
    }
}

/// Writes as entities what Markdown would read as markup between the tags of
/// `mathml`.
fn escape_markdown(mathml: &str) -> String {
    let mut escaped = String::with_capacity(mathml.len());
    let mut in_tag = false;
    for c in mathml.chars() {
        in_tag = (in_tag || c == '<') && c != '>';
        match c {
            _ if !in_tag && r#"*_[]\|`~'".-$!"#.contains(c) => {
                escaped += &format!("&#{};", u32::from(c));
            }
            '\n' => escaped.push(' '),
            _ => escaped.push(c),
        }
    }
    escaped
}
