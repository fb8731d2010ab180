//! Recognises characters that have to be escaped in a terminal.

/// Whether a terminal would act on `c` instead of showing it. Such characters include the
/// separators of lines and paragraphs, and the characters that change the direction of text.
pub fn is_terminal_control(c: char) -> bool {
    let separates_or_changes_direction = matches!(
        c,
        '\u{61c}' | '\u{200e}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    );
    c.is_control() || separates_or_changes_direction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn controls_and_direction_marks_are_terminal_controls() {
        for c in ['\u{1b}', '\n', '\u{9b}', '\u{202e}', '\u{2066}'] {
            assert!(is_terminal_control(c), "{c:?}");
        }
        for c in ['a', 'é', 'θ', '−', '×', ' '] {
            assert!(!is_terminal_control(c), "{c:?}");
        }
    }
}
