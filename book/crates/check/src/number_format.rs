//! Formats numbers and vectors for answers and sheets.

use glam::DVec3;

/// Formats a number with four decimals and a typographic minus, such as `−0.5000`.
pub(crate) fn format_four_decimals(number: f64) -> String {
    match format!("{number:.4}").as_str() {
        "-0.0000" => "0.0000".to_owned(),
        text => replace_hyphens_with_minus(text),
    }
}

/// Formats a vector with four decimals, such as `(0.0000, −0.5000, 1.0000)`.
pub(crate) fn format_vector_four_decimals(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(format_four_decimals).join(", "))
}

/// Formats numbers with a hyphen as the minus sign: one number as `-2.5`, several as
/// `(1, -2.5, 0)`.
pub(crate) fn format_with_hyphens(numbers: &[f64]) -> String {
    let texts: Vec<_> = numbers.iter().map(f64::to_string).collect();
    let list = texts.join(", ");
    if numbers.len() == 1 { list } else { format!("({list})") }
}

/// Replaces each hyphen with a typographic minus.
pub(crate) fn replace_hyphens_with_minus(text: &str) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn number_has_four_decimals_and_a_minus_if_it_is_negative() {
        assert_eq!(format_four_decimals(-0.5), "−0.5000");
        assert_eq!(format_four_decimals(2.0 / 3.0), "0.6667");
        assert_eq!(format_four_decimals(-0.000_06), "−0.0001");
        assert_eq!(format_four_decimals(-0.000_04), "0.0000");
        assert_eq!(format_four_decimals(-0.0), "0.0000");
        assert_eq!(
            format_vector_four_decimals(DVec3::new(0.0, -0.5, 1.0)),
            "(0.0000, −0.5000, 1.0000)"
        );
    }

    #[test]
    fn several_numbers_have_parentheses_and_one_number_has_none() {
        assert_eq!(format_with_hyphens(&[-2.5]), "-2.5");
        assert_eq!(format_with_hyphens(&[1.0, -2.5, 0.0]), "(1, -2.5, 0)");
        assert_eq!(replace_hyphens_with_minus(&format_with_hyphens(&[-1.0])), "−1");
    }
}
