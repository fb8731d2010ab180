//! Directives of the form `{{#kind words}}`. Only this file parses directives.

use crate::fault::{ChapterError, ChapterResult};
use crate::folded_box::BoxKind;
use crate::note::NoteKind;
use crate::replace_between::replace_between;
use std::fmt::{self, Display, Formatter};

/// A directive such as `{{#figure ray}}`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directive<'a> {
    /// The kind, such as `figure`.
    pub kind: DirectiveKind,
    /// The words after the kind, such as `ray`. The words may contain further directives, as in
    /// `{{#predict Why {{#value row:D}}?}}`.
    pub words: &'a str,
}

/// The kinds of directives. The top of lib.rs explains each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectiveKind {
    Include,
    Value,
    Number,
    OurFolder,
    Figure,
    Live,
    Preview,
    PixelPanel,
    Rows,
    Box(BoxKind),
    End,
    Problem,
    ProblemSheet,
    Mistakes,
    Check,
    Note(NoteKind),
}

impl DirectiveKind {
    /// All kinds of directives.
    pub const ALL: [Self; 21] = [
        Self::Include,
        Self::Value,
        Self::Number,
        Self::OurFolder,
        Self::Figure,
        Self::Live,
        Self::Preview,
        Self::PixelPanel,
        Self::Rows,
        Self::Box(BoxKind::Predict),
        Self::Box(BoxKind::Hints),
        Self::Box(BoxKind::Aside),
        Self::Box(BoxKind::Answer),
        Self::End,
        Self::Problem,
        Self::ProblemSheet,
        Self::Mistakes,
        Self::Check,
        Self::Note(NoteKind::Note),
        Self::Note(NoteKind::Rust),
        Self::Note(NoteKind::ByHand),
    ];

    /// The word for this kind in a directive, such as `pixel-panel`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Include => "include",
            Self::Value => "value",
            Self::Number => "number",
            Self::OurFolder => "our-folder",
            Self::Figure => "figure",
            Self::Live => "live",
            Self::Preview => "preview",
            Self::PixelPanel => "pixel-panel",
            Self::Rows => "rows",
            Self::Box(kind) => kind.name(),
            Self::End => "end",
            Self::Problem => "problem",
            Self::ProblemSheet => "problem-sheet",
            Self::Mistakes => "mistakes",
            Self::Check => "check",
            Self::Note(NoteKind::Note) => "note",
            Self::Note(NoteKind::Rust) => "rust",
            Self::Note(NoteKind::ByHand) => "by-hand",
        }
    }

    fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

impl<'a> Directive<'a> {
    /// Parses a text that consists of a single directive. Returns None for any other text, and for
    /// a directive of an unknown kind.
    pub fn parse(text: &'a str) -> Option<Self> {
        Self::parse_without_braces(text.trim().strip_prefix("{{#")?.strip_suffix("}}")?)
    }

    /// Parses the text between the braces of a directive.
    fn parse_without_braces(name_and_words: &'a str) -> Option<Self> {
        let (name, words) =
            name_and_words.split_once(char::is_whitespace).unwrap_or((name_and_words, ""));
        Some(Self { kind: DirectiveKind::from_name(name)?, words: words.trim() })
    }
}

/// Writes the directive in the form `{{#kind words}}`.
impl Display for Directive<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let space = if self.words.is_empty() { "" } else { " " };
        write!(f, "{{{{#{}{space}{}}}}}", self.kind.name(), self.words)
    }
}

/// Replaces each directive in a text with what `replacement` returns for that directive.
pub fn replace_directives(
    text: &str,
    mut replacement: impl FnMut(Directive) -> ChapterResult<String>,
) -> ChapterResult<String> {
    replace_between(text, "{{#", "}}", |name_and_words| {
        match Directive::parse_without_braces(name_and_words) {
            Some(directive) => replacement(directive),
            None => Err(ChapterError::UnknownDirective(format!("{{{{#{name_and_words}}}}}"))),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directive_is_parsed_into_kind_and_words() {
        let parse = Directive::parse;
        assert_eq!(
            parse("{{#figure ray}}\n"),
            Some(Directive { kind: DirectiveKind::Figure, words: "ray" })
        );
        assert_eq!(parse("{{#end}}"), Some(Directive { kind: DirectiveKind::End, words: "" }));
        assert_eq!(
            parse("{{#value  a }}"),
            Some(Directive { kind: DirectiveKind::Value, words: "a" })
        );
        let kind = DirectiveKind::Box(BoxKind::Predict);
        let outer = Directive { kind, words: "Is it {{#value a}}?" };
        assert_eq!(parse("{{#predict Is it {{#value a}}?}}"), Some(outer));
        for text in ["", "text", "{{figure ray}}", "{{#figure ray}} text", "{{#drawer}}"] {
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
        assert_eq!(
            replace("a {{#value b}}, {{#value c}}.").expect("both directives exist"),
            "a b, c."
        );
        assert!(replace("a {{#value b").is_err());
        let error = replace("a {{#drawer b}}").expect_err("there is no directive `drawer`");
        assert_eq!(error.to_string(), "there is no directive {{#drawer b}}");
    }
}
