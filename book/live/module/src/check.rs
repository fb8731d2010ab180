use crate::pictures::{drawn, locked, names};
use ::check::Locked;
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
    let answer = |locked: &[Locked]| {
        said(check::check(Cursor::new(file), called, name, locked))
    };
    // Each of ours takes a while to be drawn: only where it matters.
    let Ok(yours) = check::picture(Cursor::new(file)) else { return answer(&[]) };
    match name.and_then(drawn) {
        Some(ours) if !may_be_another(yours.as_ref(), &ours) => answer(&[ours]),
        _ => answer(locked()),
    }
}

/// Whether a picture may be another of ours, all of which have one size.
fn may_be_another(yours: Option<&RgbImage>, ours: &Locked) -> bool {
    yours.is_some_and(|yours| {
        yours.dimensions() == ours.picture.dimensions() && *yours != ours.picture
    })
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
