use crate::markdown::{directive, inline};

/// The boxes a chapter can have, and what stands before the author's own words in
/// their heading.
const KINDS: [(&str, &str); 3] =
    [("predict", "Predict"), ("hints", "Hints"), ("aside", "Aside")];

/// The HTML for `{{#predict a question}}`, which begins a box, or `{{#end}}`, which
/// ends it.
///
/// A reader opens the box to see what is in it.
pub fn html(kind: &str, words: &str) -> Option<Result<String, String>> {
    if kind == "end" {
        return Some(Ok("</details>\n".to_string()));
    }
    let (kind, label) = KINDS.iter().find(|(name, _)| *name == kind)?;
    Some(inline(words).map(|words| {
        format!(
            "<details class=\"{kind}\"><summary><span class=\"kind\">{label}</span> \
             <span>{words}</span></summary>\n"
        )
    }))
}

/// Finds a box without its end, or an end without its box.
pub fn balanced(text: &str) -> Result<(), (usize, String)> {
    let wrong = |at, what: &str| Err((at, what.to_string()));
    let mut open = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let (kind, _) = directive(line.trim_end()).unwrap_or_default();
        let begins = KINDS.iter().any(|(name, _)| *name == kind);
        open = match open {
            Some(_) if begins => return wrong(at, "a box can't hold another box"),
            None if kind == "end" => {
                return wrong(at, "{{#end}} without a box to end");
            }
            _ if begins => Some(at),
            _ if kind == "end" => None,
            open => open,
        };
        at += line.len();
    }
    open.map_or(Ok(()), |at| wrong(at, "the box has no {{#end}}"))
}
