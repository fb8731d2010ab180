use crate::caption;

/// The boxes a chapter can have, and what stands before the author's own words in
/// their heading.
const KINDS: [(&str, &str); 3] =
    [("predict", "Predict"), ("hints", "Hints"), ("aside", "Aside")];

/// The HTML for `{{#predict a question}}`, which begins a box, or `{{#end}}`, which
/// ends it.
///
/// A reader opens the box to see what is in it.
pub fn directive(source: &str) -> Option<Result<String, String>> {
    if source == "{{#end}}" {
        return Some(Ok("</details>\n".to_string()));
    }
    let (kind, words) =
        source.strip_prefix("{{#")?.strip_suffix("}}")?.split_once(' ')?;
    let (kind, label) = KINDS.iter().find(|(name, _)| *name == kind)?;
    Some(caption::html(words).map(|words| {
        format!(
            "<details class=\"{kind}\"><summary><span class=\"kind\">{label}</span> \
             <span>{words}</span></summary>\n"
        )
    }))
}

/// Finds a box without its end, or an end without its box.
pub fn balanced(text: &str) -> Result<(), (usize, String)> {
    let mut open = None;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let begins = KINDS
            .iter()
            .any(|(kind, _)| line.starts_with(&format!("{{{{#{kind} ")));
        match open {
            Some(_) if begins => {
                return Err((at, "a box can't hold another box".to_string()));
            }
            None if line.starts_with("{{#end}}") => {
                return Err((at, "{{#end}} without a box to end".to_string()));
            }
            _ if line.starts_with("{{#end}}") => open = None,
            _ if begins => open = Some(at),
            _ => {}
        }
        at += line.len();
    }
    open.map_or(Ok(()), |at| Err((at, "the box has no {{#end}}".to_string())))
}
