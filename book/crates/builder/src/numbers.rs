//! The numbers in a text. Values are computed when the book is built. Live numbers are updated by
//! the page while the reader changes a figure.

use crate::directive::{Directive, DirectiveKind, replace_directives};
use crate::fault::{ChapterError, ChapterResult};
use crate::values::{Notation, Values};

/// Fills in directives such as `{{#value name}}` and `{{#number row:hRes}}` in the HTML of a text.
pub fn fill_in_numbers_in_html(html: &str, values: &Values) -> ChapterResult<String> {
    replace_directives(html, |directive| number_html(directive, values))
}

/// Returns the HTML of the number that a directive in a text stands for.
pub fn number_html(directive: Directive, values: &Values) -> ChapterResult<String> {
    match directive.kind {
        DirectiveKind::Value => values.text(directive.words, Notation::Prose),
        DirectiveKind::Number => live_number_html("span", directive.words, values),
        _ => Err(ChapterError::MisplacedDirective(directive.to_string())),
    }
}

/// Fills in directives such as `{{#value name}}` in code.
pub fn fill_in_values_in_code(code: &str, values: &Values) -> ChapterResult<String> {
    replace_directives(code, |directive| match directive.kind {
        DirectiveKind::Value => values.text(directive.words, Notation::Code),
        DirectiveKind::Number => Err(ChapterError::NumberInCode(directive.to_string())),
        _ => Err(ChapterError::MisplacedDirective(directive.to_string())),
    })
}

/// Fills in directives such as `{{#value name}}` and `{{#number row:hRes}}` in a formula, and
/// converts the formula with `to_mathml`. LaTeX has no notation for live numbers, so the LaTeX
/// contains placeholders: the texts `live0`, `live1` and so on. In the MathML, the live numbers
/// replace the placeholders.
pub fn fill_in_numbers_in_formula(
    latex: &str,
    values: &Values,
    to_mathml: impl FnOnce(&str) -> ChapterResult<String>,
) -> ChapterResult<String> {
    let mut live_numbers = vec![];
    let latex = replace_directives(latex, |directive| match directive.kind {
        DirectiveKind::Value => values.text(directive.words, Notation::Code),
        DirectiveKind::Number => {
            live_numbers.push(directive.words.to_owned());
            Ok(format!("\\text{{live{}}}", live_numbers.len() - 1))
        }
        _ => Err(ChapterError::DirectiveInFormula(directive.to_string())),
    })?;
    let mathml = to_mathml(&latex)?;
    let (mut filled_mathml, mut remaining_mathml) = (String::new(), mathml.as_str());
    for (k, name) in live_numbers.into_iter().enumerate() {
        let number = live_number_html("mn", &name, values)?;
        let text = format!("<mtext>live{k}</mtext>");
        let (mathml_before, mathml_after) =
            remaining_mathml.split_once(&text).ok_or(ChapterError::NumberInFormula(name))?;
        filled_mathml += mathml_before;
        filled_mathml += &number;
        remaining_mathml = mathml_after;
    }
    Ok(filled_mathml + remaining_mathml)
}

/// Returns the HTML element for a number that the page updates. `tag` is the element's tag. At
/// first, the element contains the number for the default parameters.
pub fn live_number_html(tag: &str, name: &str, values: &Values) -> ChapterResult<String> {
    let default_text = values.text(name, Notation::Prose)?;
    Ok(format!("<{tag} data-number=\"{name}\">{default_text}</{tag}>"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn negative_value_has_a_hyphen_in_code_and_formulas() {
        let values = Values::default();
        let b = "{{#value step02_sphere:300,150:b0}}";
        assert_eq!(fill_in_numbers_in_html(b, &values).expect("the value exists"), "−10");
        assert_eq!(fill_in_values_in_code(b, &values).expect("the value exists"), "-10");
        let unchanged = |latex: &str| Ok(latex.to_owned());
        assert_eq!(
            fill_in_numbers_in_formula(b, &values, unchanged).expect("the value exists"),
            "-10"
        );
    }

    #[test]
    fn live_numbers_are_filled_into_a_formula_in_order() {
        let latex = "{{#number row:hRes}} {{#number row:D}} {{#number row:hRes}}";
        let to_mathml =
            |latex: &str| Ok(latex.replace("\\text{", "<mtext>").replace('}', "</mtext>"));
        let filled = fill_in_numbers_in_formula(latex, &Values::default(), to_mathml)
            .expect("the numbers exist");
        assert_eq!(
            filled,
            "<mn data-number=\"row:hRes\">7</mn> <mn data-number=\"row:D\">0.1925</mn> \
             <mn data-number=\"row:hRes\">7</mn>"
        );
    }

    #[test]
    fn live_number_missing_from_the_mathml_is_an_error() {
        let error = fill_in_numbers_in_formula("{{#number row:D}}", &Values::default(), |_| {
            Ok(String::new())
        });
        assert!(matches!(error, Err(ChapterError::NumberInFormula(name)) if name == "row:D"));
    }

    #[test]
    fn live_number_in_code_is_an_error() {
        let error = fill_in_values_in_code("{{#number row:D}}", &Values::default())
            .expect_err("code can't contain live numbers");
        assert!(matches!(error, ChapterError::NumberInCode(_)));
    }
}
