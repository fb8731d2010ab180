use ::check::LockedPictures;
use course::json;
use figures::Reply;

thread_local! {
    /// The locked pictures, each drawn when it is first needed.
    static LOCKED: LockedPictures = LockedPictures::new(|name| {
        let picture = course::find_picture(name).ok_or_else(|| format!("nothing draws {name}"))?;
        Ok(picture(&course::camera(), 1))
    });
}

/// The report of `check` on a file, and the pixels of the difference. The words are the
/// name of the picture that it should be, `*` where the file's name tells it, or `@` and the
/// name to which a scene belongs; behind a line break, the file's name.
pub fn check(words: &str, file: &[u8]) -> Reply {
    let (name, file_name) = words.split_once('\n').unwrap_or((words, ""));
    LOCKED.with(|locked| {
        page_answer(match (name, name.strip_prefix('@')) {
            (_, Some(name)) => ::check::check_scene_png(file, file_name, name, &[], locked),
            ("*", _) => ::check::check_png(file, file_name, None, locked),
            (name, _) => ::check::check_png(file, file_name, Some(name), locked),
        })
    })
}

/// The answer of `check` as one for the page.
fn page_answer(answer: ::check::Answer) -> Reply {
    let code = answer.verdict.exit_code().to_string();
    let mut fields = vec![("code", code), ("text", json::quote(&answer.text))];
    let mut pixels = vec![];
    if let Some(difference) = answer.draw_difference() {
        let (width, height) = difference.dimensions();
        fields.push(("size", json::list([width, height])));
        pixels = figures::rgba_bytes(&difference);
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}
