use crate::pictures::{SIZE, draw_picture};
use ::check::{Locked, Step, names};
use image::RgbImage;
use live::Answer;
use live::json;
use std::cell::RefCell;

thread_local! {
    /// Pictures of ours, in the order of their names.
    static OURS: RefCell<Vec<Locked>> = const { RefCell::new(vec![]) };
}

/// What `check` says of a PNG file, to the words `NAME FILE`: the name of the picture
/// that it should be, or `*` where the file's name tells it, and the file's name. The
/// pixels are those of the difference.
///
/// Pictures of ours are drawn when they are first needed: the one that it should be, the
/// one that it is, and those of the steps; or all where it may be any.
pub fn check(words: &str, file: &[u8]) -> Answer {
    let (name, called) = words.split_once(' ').unwrap_or((words, ""));
    let name = match name {
        "*" => check::by_file(called, names().into_iter()),
        name => Some(name),
    };
    let hash = check::read(file).map(|yours| check::sum(&yours.pixels));
    let is = |(_, right): &(_, u64)| hash.as_ref() == Ok(right);
    let is = check::locked_sums().find(is).map(|(name, _)| name);
    let is_needed = |known: &str| {
        let is_asked = name.or(is).is_none_or(|name| name == known);
        is_asked || is == Some(known) || Step::named(known).is_some()
    };
    for known in
        names().into_iter().filter(|known| hash.is_ok() && is_needed(known))
    {
        let is_kept =
            OURS.with_borrow(|ours| ours.iter().any(|one| one.name == known));
        if !is_kept && let Some(picture) = draw_picture(known, SIZE[0]) {
            insert(known, picture);
        }
    }
    OURS.with_borrow(|ours| page_answer(check::check(file, called, name, ours)))
}

/// Keeps a picture of ours that was drawn elsewhere: red, green and blue of each pixel.
///
/// # Panics
///
/// Panics where it has another size.
pub fn keep(name: &str, pixels: &[u8]) -> Answer {
    let [columns, rows] = SIZE;
    let picture = RgbImage::from_raw(columns, rows, pixels.to_vec());
    insert(name, picture.expect("all pixels of a picture of ours"));
    Answer::of([])
}

fn insert(name: &str, picture: RgbImage) {
    let place = |name: &str| names().iter().position(|known| *known == name);
    OURS.with_borrow_mut(|ours| {
        let at = ours.partition_point(|one| place(&one.name) < place(name));
        ours.insert(at, Locked { name: name.to_owned(), picture });
    });
}

/// An answer for the page.
fn page_answer(answer: check::Answer) -> Answer {
    let mut fields =
        vec![("code", answer.code.to_string()), ("text", json::text(&answer.text))];
    let mut pixels = vec![];
    if let Some(difference) = answer.difference {
        let (width, height) = difference.dimensions();
        fields.push(("size", json::list([width, height])));
        pixels = live::rgba(&difference);
    }
    Answer { pixels, ..Answer::of(fields) }
}
