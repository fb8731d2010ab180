//! Replies to requests to check a picture.

use ::check::{Answer, CheckError, FAILURE_EXIT_CODE, check_png, check_scene_png};
use course::json;
use figures::Reply;

/// Checks a file. `picture` is the name of the expected picture. If it is None, the crate `check`
/// finds out which picture the file should show.
pub fn check(file: &[u8], file_name: &str, picture: Option<&str>) -> Reply {
    let draw = |name: &str| {
        let picture = course::find_draw_function(name).map(|draw| draw(&course::camera(), 1));
        picture.ok_or_else(|| format!("nothing draws {name}"))
    };
    report(check_png(file, file_name, picture, draw))
}

/// Checks whether a file is the picture of this person's scene.
pub fn check_scene(file: &[u8], file_name: &str, person: &str) -> Reply {
    report(check_scene_png(file, file_name, person))
}

/// Makes a reply from the result of a check. The reply contains the exit code, the lines of the
/// answer and, if one of the lines names a section of the book, the address of that section. If the
/// answer compares two pictures, the reply also contains these pictures and their difference, side
/// by side.
fn report(result: Result<Answer, CheckError>) -> Reply {
    let answer = match result {
        Ok(answer) => answer,
        Err(error) => {
            let lines = json::list([json::quote(&error.to_string())]);
            let code = FAILURE_EXIT_CODE.to_string();
            return Reply::from_json_fields([("code", code), ("lines", lines)]);
        }
    };
    let lines = json::list(answer.lines().iter().map(|line| json::quote(line)));
    let mut fields = vec![("code", answer.verdict.exit_code().to_string()), ("lines", lines)];
    if let Some((line, address)) = answer.section_link() {
        fields.push(("links", json::object([(&*line, json::quote(&address))])));
    }
    let mut pixels = vec![];
    if let Some(difference) = answer.draw_comparison() {
        let (width, height) = difference.dimensions();
        fields.push(("size", json::list([width, height])));
        pixels = figures::rgba_bytes(&difference);
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}
