//! The options for parsing chapters, and conversions between Markdown and HTML.

use crate::fault::{ChapterError, ChapterResult};
use crate::values::Values;
use crate::{formula, numbers};
use mdbook_markdown::pulldown_cmark::{Event, Options, Parser, Tag, TagEnd, html};

/// The options with which mdBook parses Markdown, and the option for formulas.
pub fn markdown_options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// Converts one paragraph of Markdown to HTML without `<p>` tags. The paragraph may contain
/// formulas and numbers.
pub fn inline_html(markdown: &str, values: &Values) -> ChapterResult<String> {
    let mut events = vec![];
    for event in Parser::new_ext(markdown, markdown_options()) {
        events.push(match event {
            Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph) => continue,
            Event::InlineMath(latex) | Event::DisplayMath(latex) => {
                Event::InlineHtml(formula::formula_html(&latex, false, values)?.into())
            }
            Event::Text(text) if text.contains('$') => return Err(ChapterError::LoneDollarInWords),
            other => other,
        });
    }
    let mut text = String::new();
    html::push_html(&mut text, events.into_iter());
    numbers::fill_in_numbers_in_html(&text.replace('\n', " "), values)
}

/// Puts blank lines around HTML, so that the HTML is a block of its own in Markdown. Without the
/// blank lines, the HTML would become part of a paragraph above, and Markdown below the HTML would
/// be taken for HTML.
pub fn html_block(html: &str) -> String {
    format!("\n{}\n\n", html.trim_end())
}

/// Returns a `<code>` element that contains a name. In a narrow column, a browser may break the
/// name between two lines.
pub fn code_with_break_hints(code: &str) -> String {
    format!("<code>{}</code>", with_break_hints(code))
}

/// Returns the HTML of a name or path that a browser may break after `::`, `/` and `_`.
pub fn with_break_hints(name: &str) -> String {
    name.replace("::", "::<wbr>").replace('/', "/<wbr>").replace('_', "&#95;<wbr>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inline_html_has_no_paragraph_tags() {
        let html = |markdown| inline_html(markdown, &Values::default());
        assert_eq!(
            html("It's *one*\nline").expect("the Markdown is valid"),
            "It’s <em>one</em> line"
        );
        assert!(html("$t$").expect("the Markdown is valid").starts_with("<math>"));
        assert_eq!(
            html("{{#value step02_sphere:300,150:b0}}").expect("the Markdown is valid"),
            "−10"
        );
        assert!(matches!(html("1 $"), Err(ChapterError::LoneDollarInWords)));
        assert_eq!(html("`$name`").expect("the Markdown is valid"), "<code>$name</code>");
    }

    #[test]
    fn name_breaks_after_colons_slashes_and_underscores() {
        assert_eq!(code_with_break_hints("A::b_c"), "<code>A::<wbr>b&#95;<wbr>c</code>");
        assert_eq!(with_break_hints("src/ray.rs"), "src/<wbr>ray.rs");
    }
}
