use crate::numbers;
use math_core::{LatexToMathML, MathDisplay};

/// The MathML of a formula in LaTeX, safe to stand in a line of Markdown.
pub fn formula_html(latex: &str, is_display: bool) -> Result<String, String> {
    let style = if is_display { MathDisplay::Block } else { MathDisplay::Inline };
    let mathml = numbers::fill_in_formula(latex, |latex| {
        let converted = LatexToMathML::default().convert_with_local_state(latex, style);
        converted
            .map(|converted| converted.mathml)
            .map_err(|error| format!("the formula {} does not parse: {error}", latex.trim()))
    })?;
    let mathml = escape_markdown(&mathml);
    Ok(if is_display {
        format!(r#"<span class="formula" tabindex="0">{mathml}</span>"#)
    } else {
        mathml
    })
}

/// Writes as entities what Markdown would read as markup between the tags of
/// `mathml`.
fn escape_markdown(mathml: &str) -> String {
    let mut escaped = String::with_capacity(mathml.len());
    let mut in_tag = false;
    for c in mathml.chars() {
        in_tag = (in_tag || c == '<') && c != '>';
        match c {
            '*' | '_' | '[' | ']' | '\\' | '|' | '`' | '~' | '\'' | '"' | '.' | '-' | '$' | '!'
                if !in_tag =>
            {
                escaped += &format!("&#{};", u32::from(c));
            }
            '\n' => escaped.push(' '),
            _ => escaped.push(c),
        }
    }
    escaped
}
