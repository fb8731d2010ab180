/// A symbol in the letters of the formulas: `_` puts the next one below the line,
/// `^` above it.
pub fn symbol_spans(text: &str) -> String {
    let mut spans = String::from(r#"<tspan class="math">"#);
    let mut letters = text.chars();
    while let Some(c) = letters.next() {
        let shift = match c {
            '_' => 4.0,
            '^' => -7.0,
            _ => {
                spans += &escape(&italic_letter(c).to_string());
                continue;
            }
        };
        let shifted = letters.next().map_or(' ', italic_letter);
        spans += &format!(
            r#"<tspan class="small" dy="{shift}">{shifted}</tspan><tspan dy="{}">&#8203;</tspan>"#,
            -shift
        );
    }
    spans + "</tspan>"
}

/// The italic letter of mathematics for a Latin or small Greek letter; others stay
/// as they are.
pub fn italic_letter(c: char) -> char {
    let shifted = |first: char, base: u32| char::from_u32(base + (c as u32 - first as u32));
    let letter = match c {
        'h' => Some('ℎ'),
        'a'..='z' => shifted('a', 0x1D44E),
        'A'..='Z' => shifted('A', 0x1D434),
        'α'..='ω' => shifted('α', 0x1D6FC),
        _ => None,
    };
    letter.unwrap_or(c)
}

/// Escapes `text` for HTML, attributes included.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
