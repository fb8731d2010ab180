//! Formats numbers and names as the book writes them. A minus is a real minus sign, not a hyphen.

/// Formats a number with at most four digits after the point.
pub fn format_number(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.replace('-', "−") }
}

/// Formats a number with at most `max_decimals` digits after the point, but no more than four.
pub fn format_with_max_decimals(number: f64, max_decimals: i32) -> String {
    let power = 10_f64.powi(max_decimals);
    format_number((number * power).round() / power)
}

/// The name that the chapters use for an object. A sphere goes by its colour: the red sphere is
/// “red”.
pub fn short_name(object_name: &str) -> &str {
    object_name.trim_end_matches(" sphere")
}

/// Formats three numbers as (x, y, z).
pub fn format_vector(vector: impl Into<[f64; 3]>) -> String {
    let [x, y, z] = vector.into().map(format_number);
    format!("({x}, {y}, {z})")
}

/// Formats a count with commas between groups of three digits.
pub fn format_count(count: usize) -> String {
    let digits = count.to_string();
    let has_comma = |k: usize| k > 0 && (digits.len() - k).is_multiple_of(3);
    let digits = digits.char_indices();
    digits.map(|(k, digit)| format!("{}{digit}", if has_comma(k) { "," } else { "" })).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_at_most_four_decimals_and_a_real_minus_sign() {
        for (number, text) in
            [(1.0, "1"), (0.25, "0.25"), (-2.5, "−2.5"), (-0.00001, "0"), (1.0 / 3.0, "0.3333")]
        {
            assert_eq!(format_number(number), text);
        }
        assert_eq!(format_with_max_decimals(2.346, 2), "2.35");
        assert_eq!(format_with_max_decimals(-0.04, 1), "0");
        assert_eq!(format_vector([1.0, -0.5, 0.0]), "(1, −0.5, 0)");
    }

    #[test]
    fn count_has_a_comma_between_thousands() {
        for (count, text) in [(0, "0"), (999, "999"), (1000, "1,000"), (2_073_600, "2,073,600")] {
            assert_eq!(format_count(count), text);
        }
    }

    #[test]
    fn short_name_of_a_sphere_is_its_colour() {
        assert_eq!([short_name("red sphere"), short_name("ground")], ["red", "ground"]);
    }
}
