//! The boxes that are folded until a reader opens them, such as hints and answers.

use crate::fault::ChapterResult;
use crate::markdown::inline_html;
use crate::values::Values;

/// The kinds of folded boxes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoxKind {
    Predict,
    Hints,
    Aside,
    Answer,
}

impl BoxKind {
    /// The name of the directive, which is also the CSS class of the box.
    pub fn name(self) -> &'static str {
        match self {
            Self::Predict => "predict",
            Self::Hints => "hints",
            Self::Aside => "aside",
            Self::Answer => "answer",
        }
    }

    /// The label that precedes the author's words in the heading.
    fn label(self) -> &'static str {
        match self {
            Self::Predict => "Predict",
            Self::Hints => "Hints",
            Self::Aside => "Aside",
            Self::Answer => "Answer",
        }
    }
}

/// Returns the HTML that opens a box, for a directive such as `{{#predict a question}}`.
pub fn opening_html(kind: BoxKind, summary: &str, values: &Values) -> ChapterResult<String> {
    let (name, label, words) = (kind.name(), kind.label(), inline_html(summary, values)?);
    Ok(format!(
        "<details class=\"{name}\"><summary><span class=\"kind\">{label}</span> \
         <span>{words}</span></summary>\n"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn box_heading_begins_with_the_label_of_its_kind() {
        let html = opening_html(BoxKind::Predict, "Why *is* it?", &Values::default());
        let html = html.expect("the summary is valid");
        assert!(html.starts_with("<details class=\"predict\"><summary>"), "{html}");
        let heading = "<span class=\"kind\">Predict</span> <span>Why <em>is</em> it?</span>";
        assert!(html.contains(heading), "{html}");
    }
}
