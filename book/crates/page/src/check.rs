//! Replies to the requests of the forms that look at a picture.

use ::check::{check_png, check_scene_png};
use course::json;
use figures::Reply;

/// The report of `check` on a file, and the pixels of the difference. The words are the
/// name of the picture that it should be, `*` where the file's name tells it, or `@` and the
/// name to which a scene belongs; behind a line break, the file's name.
pub fn check(words: &str, file: &[u8]) -> Reply {
    let draw = |name: &str| {
        let picture = course::find_picture(name).ok_or_else(|| format!("nothing draws {name}"))?;
        Ok(picture(&course::camera(), 1))
    };
    let (name, file_name) = words.split_once('\n').unwrap_or((words, ""));
    let answer = match name.strip_prefix('@') {
        Some(scene) => check_scene_png(file, file_name, scene),
        None => check_png(file, file_name, Some(name).filter(|name| *name != "*"), draw),
    };
    let mut fields =
        vec![("code", answer.verdict.exit_code().to_string()), ("text", json::quote(&answer.text))];
    let mut pixels = vec![];
    if let Some(difference) = answer.draw_difference() {
        let (width, height) = difference.dimensions();
        fields.push(("size", json::list([width, height])));
        pixels = figures::rgba_bytes(&difference);
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}
