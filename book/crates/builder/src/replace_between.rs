//! Replaces the pieces of a text that are between two marks.

use thiserror::Error;

/// The error for a piece that has a `begin` but no `end`.
#[derive(Debug, Error, PartialEq)]
#[error("{begin} isn't closed by {end}")]
pub struct MissingEnd {
    begin: &'static str,
    end: &'static str,
}

/// Finds each piece of a text that goes from `begin` to the next `end`. Calls `replacement` with
/// what is between these two marks. Replaces the piece, including the two marks, with the result.
pub fn replace_between<E: From<MissingEnd>>(
    text: &str,
    begin: &'static str,
    end: &'static str,
    mut replacement: impl FnMut(&str) -> Result<String, E>,
) -> Result<String, E> {
    let mut parts = text.split(begin);
    let mut replaced = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (inner_text, tail) = part.split_once(end).ok_or(MissingEnd { begin, end })?;
        replaced += &replacement(inner_text)?;
        replaced += tail;
    }
    Ok(replaced)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn upper_case_between_angle_brackets(text: &str) -> Result<String, MissingEnd> {
        replace_between(text, "<", ">", |inner_text| Ok(inner_text.to_uppercase()))
    }

    #[test]
    fn each_piece_is_replaced() {
        assert_eq!(upper_case_between_angle_brackets("a <b> c<d>").as_deref(), Ok("a B cD"));
        assert_eq!(upper_case_between_angle_brackets("a > b").as_deref(), Ok("a > b"));
    }

    #[test]
    fn piece_without_an_end_is_an_error() {
        assert_eq!(
            upper_case_between_angle_brackets("a <b> <c"),
            Err(MissingEnd { begin: "<", end: ">" })
        );
    }
}
