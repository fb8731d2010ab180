//! Converts formulas from LaTeX to MathML.

use crate::fault::{ChapterError, ChapterResult};
use crate::numbers;
use crate::values::Values;
use math_core::{LatexToMathML, MathDisplay};
use std::thread;

/// The maximum number of commands and braces in a formula. Each of them can add a level of nesting,
/// and the parser uses up to 60 kB of stack for each level.
const MAX_MARKS: usize = 100;
/// The stack size of the thread that parses a formula.
const STACK_BYTES: usize = 16 << 20;

/// Converts a LaTeX formula to MathML. The MathML is escaped so that Markdown leaves it unchanged.
pub fn formula_html(latex: &str, is_display: bool, values: &Values) -> ChapterResult<String> {
    let style = if is_display { MathDisplay::Block } else { MathDisplay::Inline };
    let mathml = numbers::fill_in_numbers_in_formula(latex, values, |latex| convert(latex, style))?;
    let mathml = escape_markdown(&mathml);
    Ok(if is_display {
        format!(r#"<span class="formula" tabindex="0">{mathml}</span>"#)
    } else {
        mathml
    })
}

/// Converts a formula whose numbers have already been filled in.
fn convert(latex: &str, style: MathDisplay) -> ChapterResult<String> {
    let latex = latex.trim();
    if latex.matches(['\\', '{']).count() > MAX_MARKS {
        return Err(ChapterError::LongFormula(MAX_MARKS));
    }
    let convert = || LatexToMathML::default().convert_with_local_state(latex, style);
    let conversion = thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, convert);
        thread.ok()?.join().ok()
    });
    let formula_error = |source| ChapterError::Formula { latex: latex.to_owned(), source };
    match conversion {
        Some(Ok(output)) => Ok(align_subscripts(output.mathml)),
        Some(Err(error)) => Err(formula_error(Some(error))),
        None => Err(formula_error(None)),
    }
}

/// Puts the subscript of a letter with a descender at the same height as other subscripts, so that
/// y₀ looks like x₀. A browser would put the subscript of y lower, below the descender. A depth of
/// 0 tells the browser that the letter has no descender.
fn align_subscripts(mut mathml: String) -> String {
    for letter in ["g", "p", "q", "y"] {
        let plain = format!("<msub><mi>{letter}</mi>");
        let aligned = format!("<msub><mpadded depth=\"0\"><mi>{letter}</mi></mpadded>");
        mathml = mathml.replace(&plain, &aligned);
    }
    mathml
}

/// Outside the tags of `mathml`, escapes the characters that Markdown would read as markup.
fn escape_markdown(mathml: &str) -> String {
    let mut escaped_mathml = String::with_capacity(mathml.len());
    let mut in_tag = false;
    for c in mathml.chars() {
        in_tag = (in_tag || c == '<') && c != '>';
        match c {
            _ if !in_tag && r#"*_[]\|`~'".-$!"#.contains(c) => {
                escaped_mathml += &format!("&#{};", u32::from(c));
            }
            '\n' => escaped_mathml.push(' '),
            _ => escaped_mathml.push(c),
        }
    }
    escaped_mathml
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markdown_signs_are_escaped_outside_of_tags() {
        assert_eq!(escape_markdown("<mi a_b=\"c\">a_*</mi>\n"), "<mi a_b=\"c\">a&#95;&#42;</mi> ");
    }

    #[test]
    fn subscripts_of_x_and_y_are_level() {
        let html =
            formula_html("(x_0, y_0)", false, &Values::default()).expect("the formula is valid");
        assert!(html.contains("<msub><mi>x</mi><mn>0</mn></msub>"), "{html}");
        let aligned = "<msub><mpadded depth=\"0\"><mi>y</mi></mpadded><mn>0</mn></msub>";
        assert!(html.contains(aligned), "{html}");
    }

    #[test]
    fn live_number_in_a_formula_has_its_own_element() {
        for name in ["row:D", "step02_sphere:t", "step05_phong:d warm"] {
            let latex = format!("x = {{{{#number {name}}}}}");
            let html = formula_html(&latex, false, &Values::default()).expect(name);
            assert!(html.contains(&format!("<mn data-number=\"{name}\">")), "{html}");
        }
    }
}
