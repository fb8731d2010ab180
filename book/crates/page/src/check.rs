//! Replies to requests to check a picture.

use ::check::{check_png, check_scene_png};
use course::json;
use figures::Reply;

/// Runs `check` on a file, and replies with its report and the pixels of the difference. `words`
/// starts with the name of the expected picture, with `*` to let `check` find that out, or with `@`
/// and the name of the person whose scene it should be. After a line break comes the file's name.
pub fn check(words: &str, file: &[u8]) -> Reply {
    let draw = |name: &str| {
        let picture = course::find_picture(name).map(|picture| picture(&course::camera(), 1));
        picture.ok_or_else(|| format!("nothing draws {name}"))
    };
    let (name, file_name) = words.split_once('\n').unwrap_or((words, ""));
    let result = match name.strip_prefix('@') {
        Some(scene) => check_scene_png(file, file_name, scene),
        None => check_png(file, file_name, Some(name).filter(|name| *name != "*"), draw),
    };
    let answer = match result {
        Ok(answer) => answer,
        Err(error) => {
            let lines = json::list([json::quote(&error.to_string())]);
            return Reply::from_json_fields([("code", "2".to_owned()), ("lines", lines)]);
        }
    };
    let lines = json::list(answer.lines().iter().map(|line| json::quote(line)));
    let mut fields = vec![("code", answer.verdict.exit_code().to_string()), ("lines", lines)];
    let mut pixels = vec![];
    if let Some(difference) = answer.draw_difference() {
        let (width, height) = difference.dimensions();
        fields.push(("size", json::list([width, height])));
        pixels = figures::rgba_bytes(&difference);
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}
