//! Boxes that a reader opens.

use crate::fault::ChapterResult;
use crate::markdown::inline_html;
use crate::values::Values;

/// The kinds of boxes, and the word before the author's own words in the heading of each.
const KINDS: [(&str, &str); 4] =
    [("predict", "Predict"), ("hints", "Hints"), ("aside", "Aside"), ("answer", "Answer")];

/// The HTML for `{{#predict a question}}`, which begins a box that a reader opens.
pub fn opening_html(kind: &str, summary: &str, values: &Values) -> Option<ChapterResult<String>> {
    let (kind, label) = KINDS.iter().find(|(name, _)| *name == kind)?;
    Some(inline_html(summary, values).map(|words| {
        format!(
            "<details class=\"{kind}\"><summary><span class=\"kind\">{label}</span> \
             <span>{words}</span></summary>\n"
        )
    }))
}
