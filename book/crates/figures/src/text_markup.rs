//! Texts as HTML and SVG: symbols in the letters of the formulas, and escapes.

/// A symbol in the letters of the formulas: `_` puts the next one below the line.
pub fn symbol_spans(text: &str) -> String {
    let mut spans = String::from(r#"<tspan class="math">"#);
    let mut letters = text.chars().map(italic_letter);
    while let Some(letter) = letters.next() {
        if letter == '_' {
            let low = letters.next().unwrap_or(' ');
            spans += &format!(
                r#"<tspan class="small" dy="4">{low}</tspan><tspan dy="-4">&#8203;</tspan>"#
            );
        } else {
            spans += &escape(&letter.to_string());
        }
    }
    spans + "</tspan>"
}

/// The italic letter of mathematics for a Latin or small Greek letter. Any other character stays as it
/// is.
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
