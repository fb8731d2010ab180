//! The box "This pixel" below an interactive picture, which shows every number on the way from the
//! chosen pixel's ray to its three bytes.

use crate::fault::{ChapterError, ChapterResult};
use crate::numbers;
use crate::values::{Notation, Values};
use figures::short_name;
use step03_nearest::OBJECTS;

/// The HTML for `{{#pixel-panel step04_diffuse}}`, which begins that picture's box. The chapter
/// continues with the text in the box, in which a `{{#number …}}` stands for each number that
/// depends on the pixel, up to `{{#end}}`.
///
/// The box is hidden until book/theme/figure.js shows it, since it doesn't work without scripts.
pub fn opening_html(picture: &str) -> String {
    format!(
        "<details data-panel=\"{picture}\" class=\"aside\" hidden>\
         <summary><span class=\"kind\">This pixel</span></summary>\n"
    )
}

/// Returns the rows of a table for `{{#rows step04_diffuse sphere a b c}}`. The first row has that
/// picture's numbers a0, b0 and c0, the second a1, b1 and c1, and so on, for as long as the last
/// column has a number. The column `sphere` has the names of the spheres.
pub fn rows_markdown(words: &str, values: &Values) -> ChapterResult<String> {
    let mut words = words.split_whitespace();
    let (Some(picture), columns) = (words.next(), words.collect::<Vec<_>>()) else {
        return Err(ChapterError::RowsForm);
    };
    let last = columns.last().ok_or(ChapterError::RowsForm)?;
    let count = (0..)
        .take_while(|k| values.text(&format!("{picture}:{last}{k}"), Notation::Prose).is_ok())
        .count();
    // If the last column doesn't exist at all, the first row reports that.
    (0..count.max(1)).map(|k| row_markdown(picture, &columns, k, values)).collect()
}

fn row_markdown(
    picture: &str,
    columns: &[&str],
    k: usize,
    values: &Values,
) -> ChapterResult<String> {
    let mut row = String::new();
    for column in columns {
        row += "| ";
        row += &match *column {
            "sphere" => OBJECTS.get(k).map_or("", |object| short_name(object.name)).to_owned(),
            name => numbers::live_number_html("span", &format!("{picture}:{name}{k}"), values)?,
        };
        row += " ";
    }
    Ok(row + "|\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_end_with_the_last_sphere() {
        let values = Values::default();
        let rows = rows_markdown("step03_nearest sphere a", &values).expect("rows");
        assert_eq!(rows.lines().count(), OBJECTS.len());
        let first = rows.lines().next().unwrap_or_default();
        let a = values.text("step03_nearest:a0", Notation::Prose).expect("a number");
        assert_eq!(first, format!("| red | <span data-number=\"step03_nearest:a0\">{a}</span> |"));
    }

    #[test]
    fn rows_without_columns_or_numbers_are_an_error() {
        for words in ["", "step03_nearest"] {
            assert!(
                matches!(rows_markdown(words, &Values::default()), Err(ChapterError::RowsForm)),
                "{words}"
            );
        }
        for words in ["step03_nearest nothing", "nowhere a"] {
            assert!(
                matches!(
                    rows_markdown(words, &Values::default()),
                    Err(ChapterError::UnknownValue(_))
                ),
                "{words}"
            );
        }
    }
}
