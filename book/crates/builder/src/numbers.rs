//! The numbers in a text: values, computed when the book is built, and those that move
//! when a reader moves what answers.

use crate::directive::{Directive, replace_directives};
use crate::fault::{ChapterError, ChapterResult};
use crate::replace_between::replace_between;
use crate::values;

/// A text with the numbers of `{{#value name}}` and `{{#number row:hRes}}` in it.
pub fn fill_in_text(text: &str) -> ChapterResult<String> {
    replace_directives(text, number_html)
}

/// The number of a directive in a text.
pub fn number_html(directive: Directive) -> ChapterResult<String> {
    match directive.kind {
        "value" => values::value_text(directive.words),
        "number" => moving_number_html("span", directive.words),
        _ => Err(ChapterError::MisplacedDirective(directive.to_string())),
    }
}

/// The same for a formula: `to_mathml` gets it with a mark where a number moves.
pub fn fill_in_formula(
    latex: &str,
    to_mathml: impl FnOnce(&str) -> ChapterResult<String>,
) -> ChapterResult<String> {
    let marked = replace_directives(latex, |directive| match directive.kind {
        "value" => Ok(values::value_text(directive.words)?.replace('−', "-")),
        "number" => Ok(format!("\\text{{⟦{}⟧}}", directive.words)),
        _ => Err(ChapterError::DirectiveInFormula(directive.to_string())),
    })?;
    replace_between(&to_mathml(&marked)?, "<mtext>⟦", "⟧</mtext>", |number_name| {
        moving_number_html("mn", number_name)
    })
}

/// A number that moves, as it is printed: a value of what answers.
pub fn moving_number_html(tag: &str, number_name: &str) -> ChapterResult<String> {
    let default_text = values::value_text(number_name)?;
    Ok(format!("<{tag} data-number=\"{number_name}\">{default_text}</{tag}>"))
}
