//! The boxes that a reader opens, such as hints and answers.

use crate::fault::ChapterResult;
use crate::markdown::inline_html;
use crate::values::Values;

/// The kinds of boxes, each with the label before the author's words in its heading.
const KINDS: [(&str, &str); 4] =
    [("predict", "Predict"), ("hints", "Hints"), ("aside", "Aside"), ("answer", "Answer")];

/// The HTML for a directive such as `{{#predict a question}}`, which begins a box. Returns None if
/// there is no such kind of box.
pub fn opening_html(kind: &str, summary: &str, values: &Values) -> Option<ChapterResult<String>> {
    let (kind, label) = KINDS.iter().find(|(name, _)| *name == kind)?;
    Some(inline_html(summary, values).map(|words| {
        format!(
            "<details class=\"{kind}\"><summary><span class=\"kind\">{label}</span> \
             <span>{words}</span></summary>\n"
        )
    }))
}
