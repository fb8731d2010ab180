//! Symbols in HTML and SVG, written as in the formulas.

use course::escape_html;

/// Writes a symbol as SVG, in the italic letters of the formulas. `_` makes the next character a
/// subscript.
pub fn symbol_tspans(symbol: &str) -> String {
    let mut spans = String::from(r#"<tspan class="math">"#);
    let mut letters = symbol.chars().map(italic_letter);
    while let Some(letter) = letters.next() {
        if letter == '_' {
            let subscript = letters.next().unwrap_or(' ');
            spans += &format!(
                r#"<tspan class="small" dy="4">{subscript}</tspan><tspan dy="-4">&#8203;</tspan>"#
            );
        } else {
            spans += &escape_html(&letter.to_string());
        }
    }
    spans + "</tspan>"
}

/// The mathematical italic form of a Latin or lower-case Greek letter. Any other character is
/// returned unchanged.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_become_italic_and_other_characters_stay_unchanged() {
        for (letter, italic) in [('h', 'ℎ'), ('θ', '𝜃'), ('D', '𝐷'), ('2', '2')] {
            assert_eq!(italic_letter(letter), italic);
        }
    }

    #[test]
    fn underscore_makes_the_next_letter_a_subscript() {
        let spans = symbol_tspans("V_0");
        let start = "<tspan class=\"math\">𝑉<tspan class=\"small\" dy=\"4\">0</tspan>";
        assert!(spans.starts_with(start), "{spans}");
        assert!(symbol_tspans("<").contains("&lt;"));
    }
}
