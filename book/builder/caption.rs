use crate::{formula, page};
use mdbook_markdown::pulldown_cmark::{CowStr, Event, Parser, Tag, TagEnd, html};

/// The HTML of one paragraph of Markdown, formulas included, without the tags of
/// the paragraph.
pub fn html(markdown: &str) -> Result<String, String> {
    let mut mistake = None;
    let mut mathml = |latex: &CowStr| match formula::mathml(latex, false) {
        Ok(mathml) => Event::InlineHtml(mathml.into()),
        Err(what) => {
            mistake = Some(what);
            Event::SoftBreak
        }
    };
    let events: Vec<_> = Parser::new_ext(markdown, page::options())
        .filter(|event| {
            !matches!(
                event,
                Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph)
            )
        })
        .map(|event| match event {
            Event::InlineMath(latex) | Event::DisplayMath(latex) => mathml(&latex),
            other => other,
        })
        .collect();
    let mut text = String::new();
    html::push_html(&mut text, events.into_iter());
    match mistake {
        Some(what) => Err(what),
        None if text.contains('$') => Err("a lone $ in the caption".to_string()),
        None => Ok(text.replace('\n', " ")),
    }
}

/// Escapes `text` for HTML, attributes included.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// A number as prose has it, with a minus sign; in code, where it is `literal`,
/// with a hyphen.
pub fn minus(number: &str, literal: bool) -> String {
    if literal { number.to_string() } else { number.replace('-', "−") }
}
