//! The box "This pixel" below an interactive picture. The box shows every number in the computation
//! of the chosen pixel, from the pixel's ray to its three bytes.

use crate::fault::{ChapterError, ChapterResult};
use crate::numbers;
use crate::values::Values;
use figures::{find_figure, row_readout_name, short_name};
use step03_nearest::OBJECTS;

/// Returns the HTML for `{{#pixel-panel step04_diffuse}}`, which begins the box of the picture
/// `step04_diffuse`. In the chapter, the text in the box follows, up to `{{#end}}`. In this text,
/// each number that depends on the pixel is written as `{{#number …}}`.
///
/// The HTML hides the box, since the box doesn't work without scripts. If scripts are enabled,
/// book/theme/css/live.css shows the box from the start.
pub fn opening_html(picture: &str) -> String {
    format!(
        "<details data-panel=\"{picture}\" class=\"aside\" hidden>\
         <summary><span class=\"kind\">This pixel</span></summary>\n"
    )
}

/// Returns the rows of a table for `{{#rows step04_diffuse sphere a b c}}`. The first row has the
/// numbers a0, b0 and c0 of the picture `step04_diffuse`. The second row has a1, b1 and c1, and so
/// on. The column `sphere` has the names of the spheres. book/theme/figure.js uses these names to
/// find the row of the sphere that was hit.
pub fn rows_markdown(words: &str, values: &Values) -> ChapterResult<String> {
    let mut words = words.split_whitespace();
    let (Some(picture), columns) = (words.next(), words.collect::<Vec<_>>()) else {
        return Err(ChapterError::RowsForm);
    };
    if columns.is_empty() {
        return Err(ChapterError::RowsForm);
    }
    let figure =
        find_figure(picture).ok_or_else(|| ChapterError::UnknownFigure(picture.to_owned()))?;
    if figure.row_count == 0 {
        return Err(ChapterError::NoRows(picture.to_owned()));
    }
    (0..figure.row_count).map(|k| row_markdown(picture, &columns, k, values)).collect()
}

/// Returns the row with index `k`, for one sphere or one ray.
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
            "sphere" => {
                let name = OBJECTS.get(k).map_or("", |object| short_name(object.name));
                format!("<span data-object=\"{name}\">{name}</span>")
            }
            column => {
                let name = format!("{picture}:{}", row_readout_name(column, k));
                numbers::live_number_html("span", &name, values)?
            }
        };
        row += " ";
    }
    Ok(row + "|\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::values::Notation;

    #[test]
    fn there_is_a_row_for_each_sphere() {
        let values = Values::default();
        let rows = rows_markdown("step03_nearest sphere a", &values).expect("the columns exist");
        assert_eq!(rows.lines().count(), OBJECTS.len());
        let first_row = rows.lines().next().unwrap_or_default();
        let a = values.text("step03_nearest:a0", Notation::Prose).expect("the value exists");
        assert_eq!(
            first_row,
            format!(
                "| <span data-object=\"red\">red</span> | \
                 <span data-number=\"step03_nearest:a0\">{a}</span> |"
            )
        );
    }

    #[test]
    fn rows_need_a_picture_with_rows_and_known_columns() {
        for words in ["", "step03_nearest"] {
            assert!(
                matches!(rows_markdown(words, &Values::default()), Err(ChapterError::RowsForm)),
                "{words}"
            );
        }
        let error = |words| rows_markdown(words, &Values::default()).expect_err(words).to_string();
        assert_eq!(error("step03_nearest nothing"), "there is no value step03_nearest:nothing0");
        assert_eq!(error("nowhere a"), "there is no figure nowhere");
        assert_eq!(error("step01_rays a"), "the picture step01_rays has no rows");
    }
}
