//! Directives, `{{#kind words}}`. Only this file parses their braces.

use crate::fault::ChapterResult;
use crate::replace_between::replace_between;
use std::fmt::{self, Display, Formatter};

/// A directive such as `{{#figure ray}}`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directive<'a> {
    /// Its kind, such as `figure`.
    pub kind: &'a str,
    /// The rest of it, such as `ray`. It may contain further directives, as in
    /// `{{#predict Why {{#value row:D}}?}}`.
    pub words: &'a str,
}

impl<'a> Directive<'a> {
    /// Parses a text that is one directive and nothing else. Returns None for any other text.
    pub fn parse(text: &'a str) -> Option<Self> {
        text.trim().strip_prefix("{{#")?.strip_suffix("}}").map(Self::from_inside)
    }

    /// Parses the text between the braces.
    fn from_inside(inside: &'a str) -> Self {
        let (kind, words) = inside.split_once(char::is_whitespace).unwrap_or((inside, ""));
        Self { kind, words: words.trim() }
    }
}

/// Writes the directive as its author did.
impl Display for Directive<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let space = if self.words.is_empty() { "" } else { " " };
        write!(f, "{{{{#{}{space}{}}}}}", self.kind, self.words)
    }
}

/// Replaces each directive in a text with what `replacement` returns for it.
pub fn replace_directives(
    text: &str,
    mut replacement: impl FnMut(Directive) -> ChapterResult<String>,
) -> ChapterResult<String> {
    replace_between(text, "{{#", "}}", |inside| replacement(Directive::from_inside(inside)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directive_is_a_kind_and_words() {
        let parse = Directive::parse;
        assert_eq!(parse("{{#figure ray}}\n"), Some(Directive { kind: "figure", words: "ray" }));
        assert_eq!(parse("{{#end}}"), Some(Directive { kind: "end", words: "" }));
        assert_eq!(parse("{{#value  a }}"), Some(Directive { kind: "value", words: "a" }));
        let inner = Directive { kind: "predict", words: "Is it {{#value a}}?" };
        assert_eq!(parse("{{#predict Is it {{#value a}}?}}"), Some(inner));
        for text in ["", "text", "{{figure ray}}", "{{#figure ray}} text"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }

    #[test]
    fn directive_is_displayed_as_it_is_written() {
        for text in ["{{#end}}", "{{#value row:D}}"] {
            assert_eq!(Directive::parse(text).expect(text).to_string(), text);
        }
    }

    #[test]
    fn directives_in_a_text_are_replaced() {
        let replace = |text| replace_directives(text, |directive| Ok(directive.words.to_owned()));
        assert_eq!(replace("a {{#value b}}, {{#value c}}.").expect("a text"), "a b, c.");
        assert!(replace("a {{#value b").is_err());
    }
}
