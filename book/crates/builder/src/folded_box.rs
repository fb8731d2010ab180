//! The boxes that a reader opens, such as hints and answers.

use crate::fault::ChapterResult;
use crate::markdown::inline_html;
use crate::values::Values;

/// The kinds of boxes, each with the label that precedes the author's words in its heading.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heading_begins_with_the_kind() {
        let opening = |kind| opening_html(kind, "Why *is* it?", &Values::default());
        let html = opening("predict").expect("a box").expect("a heading");
        assert!(html.starts_with("<details class=\"predict\"><summary>"), "{html}");
        let heading = "<span class=\"kind\">Predict</span> <span>Why <em>is</em> it?</span>";
        assert!(html.contains(heading), "{html}");
        assert!(opening("drawer").is_none());
    }
}
