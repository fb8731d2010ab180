//! The space that a label takes up in a drawing.

use glam::DVec2;

/// The radius of a handle on a phone, where handles are largest in comparison with the drawing.
const HANDLE_RADIUS: f64 = 11.0;

/// The smallest distance that a label keeps from other labels and from the border.
const MARGIN: f64 = 2.0;

/// A rectangle that contains the text of a label.
///
/// The width is an estimate from the characters, because only a browser knows the fonts. A test in
/// tests/browser checks whether labels overlap in a browser.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LabelBox {
    min: DVec2,
    max: DVec2,
}

impl LabelBox {
    /// The box around a text whose baseline is at `position`. The class determines the font size,
    /// and whether the text begins, ends or is centred at `position`.
    pub fn new(class: &str, position: DVec2, text: &str) -> Self {
        let has = |name: &str| class.split(' ').any(|word| word == name);
        // The font sizes are those in the theme's css/drawing.css. For small text, this code uses
        // the size on a phone, where small text is largest.
        let size = match () {
            () if ["strong", "accent", "second"].into_iter().any(has) => 18.0,
            () if ["quiet", "small"].into_iter().any(has) => 15.5,
            () => 16.0,
        };
        let width = size * width_in_em(text);
        let left_width = match () {
            () if has("start") => 0.0,
            () if has("end") => width,
            () => width / 2.0,
        };
        let min = position - DVec2::new(left_width, 0.74 * size);
        Self { min, max: min + DVec2::new(width, 0.98 * size) }
    }

    /// The smallest shift that moves the box inside a drawing of this size. A margin remains
    /// between the box and the border, because the letters may be wider than estimated.
    pub fn shift_into(&self, drawing_size: DVec2) -> DVec2 {
        let max = drawing_size - MARGIN;
        (MARGIN - self.min).max(DVec2::ZERO) - (self.max - max).max(DVec2::ZERO)
    }

    /// Whether the two boxes intersect, or the gap between them is smaller than `MARGIN`.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmplt(other.max + MARGIN).all() && other.min.cmplt(self.max + MARGIN).all()
    }

    /// Whether a handle at this position would cover a part of the box.
    pub fn is_covered_by_handle(&self, position: DVec2) -> bool {
        position.distance(position.clamp(self.min, self.max)) < HANDLE_RADIUS
    }
}

/// The width of a text in multiples of the font size. Symbols are between dollar signs.
fn width_in_em(text: &str) -> f64 {
    let mut is_symbol = false;
    let mut previous = ' ';
    let mut width = 0.0;
    for letter in text.chars() {
        match letter {
            '$' => is_symbol = !is_symbol,
            '_' if is_symbol => {}
            _ if is_symbol && previous == '_' => width += 0.45,
            // Symbols are larger than other text, and their slanted capitals need extra room.
            'A'..='Z' if is_symbol => width += 0.88,
            _ if is_symbol => width += 1.08 * letter_width(letter),
            _ => width += letter_width(letter),
        }
        previous = letter;
    }
    width
}

/// The width of a letter in multiples of the font size.
fn letter_width(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '·' | ' ' | '\'' => 0.26,
        'f' | 't' | 'r' | '(' | ')' | '/' => 0.37,
        'm' | 'w' | 'M' | 'W' => 0.83,
        'A'..='Z' => 0.66,
        _ => 0.54,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn box_begins_or_ends_at_its_position() {
        let position = DVec2::new(100.0, 50.0);
        let [start, middle, end] =
            ["start", "", "end"].map(|class| LabelBox::new(class, position, "four"));
        assert_eq!((start.min.x, end.max.x), (100.0, 100.0));
        assert_eq!((middle.min.x + middle.max.x) / 2.0, 100.0);
    }

    #[test]
    fn boxes_closer_than_the_margin_overlap() {
        let box_at = |x| LabelBox { min: DVec2::new(x, 0.0), max: DVec2::new(x + 10.0, 10.0) };
        let overlaps = [5.0, 11.0, 13.0].map(|x| box_at(0.0).overlaps(&box_at(x)));
        assert_eq!(overlaps, [true, true, false]);
    }

    #[test]
    fn handle_covers_a_disc() {
        let label_box = LabelBox { min: DVec2::ZERO, max: DVec2::splat(30.0) };
        let positions = [15.0, 40.0, 42.0].map(|x| DVec2::new(x, 15.0));
        let is_covered = |position| label_box.is_covered_by_handle(position);
        assert_eq!(positions.map(is_covered), [true, true, false]);
        assert!(is_covered(DVec2::splat(37.0)) && !is_covered(DVec2::splat(38.0)));
    }

    #[test]
    fn box_is_shifted_only_as_far_as_needed() {
        let label_box = LabelBox { min: DVec2::new(-3.0, 5.0), max: DVec2::new(20.0, 104.0) };
        assert_eq!(label_box.shift_into(DVec2::splat(100.0)), DVec2::new(5.0, -6.0));
    }

    #[test]
    fn subscripts_and_dollar_signs_need_little_room() {
        assert!(width_in_em("$V_0$") < width_in_em("V_0") + 0.1);
        assert_eq!(width_in_em("$$"), 0.0);
    }
}
