use crate::pictures::{drawn, locked, names};
use image::RgbImage;
use live::Answer;
use live::json::{self, Json};
use std::io::Cursor;

/// What `check` says of a PNG file, to the words `NAME FILE`: the name of the picture
/// that it should be, or `*` where the file's name tells it, and the file's name. The
/// pixels are those of the difference.
pub fn check(words: &str, file: &[u8]) -> Answer {
    let (name, called) = words.split_once(' ').unwrap_or((words, ""));
    let name = match name {
        "*" => check::by_file(called, names()),
        name => Some(name),
    };
    let told = name.and_then(|name| Some([drawn(name)?]));
    let ours = match &told {
        Some(told) if !may_be_another(file, &told[0].picture) => told,
        _ => locked(),
    };
    said(check::check(Cursor::new(file), called, name, ours))
}

/// Whether a file may be another of our pictures than `ours`, each of which takes a while
/// to be drawn: they have one size.
fn may_be_another(file: &[u8], ours: &RgbImage) -> bool {
    let is_other =
        |yours: RgbImage| yours.dimensions() == ours.dimensions() && yours != *ours;
    check::picture(Cursor::new(file)).is_some_and(is_other)
}

/// An answer for the page.
fn said(answer: check::Answer) -> Answer {
    let mut fields =
        vec![("code", f64::from(answer.code).into()), ("text", answer.text.into())];
    let mut pixels = vec![];
    if let Some(difference) = answer.difference {
        let (width, height) = difference.dimensions();
        let size = [width, height].map(|side| Json::from(f64::from(side)));
        fields.push(("size", Json::list(size)));
        pixels = live::rgba(&difference);
    }
    Answer { text: json::object(fields), pixels }
}
