use crate::{Answer, escape_for_terminal, read_bounded_file, read_png};
use course::Difference;
use std::path::Path;

/// Tells whether the picture in a file is the scene that belongs to a name; an error is a
/// sentence about why the file is no picture.
pub fn check_named_scene(name: &str, file: &Path) -> Result<Answer, String> {
    let yours = read_png(&read_bounded_file(file)?)
        .map_err(|what| format!("{} {what}", escape_for_terminal(&file.display().to_string())))?;
    let (_, ours) = course::draw_named_scene(name);
    let name = escape_for_terminal(name);
    let differ = match Difference::between(&ours, &yours.pixels) {
        None => {
            let text = format!("Right: this is the scene of {name}, in every pixel.");
            return Ok(Answer::new(0, text));
        }
        Some(Difference::Size((w, h), (columns, rows))) => {
            format!("it has {columns}×{rows} pixels, and ours {w}×{h}")
        }
        Some(Difference::Pixels { count, largest, first: (i, j), .. }) => format!(
            "{count} of {} pixels differ, by up to {largest} of 255; the first is in \
             column {i}, row {j}",
            ours.width() * ours.height()
        ),
    };
    Ok(Answer::new(1, format!("Not the scene of {name}: {differ}.")))
}
