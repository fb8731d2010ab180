use crate::draw_picture::{SIZE, draw_picture};
use ::check::Locked;
use course::{Step, json, locked_names};
use figures::Reply;
use image::RgbImage;
use std::cell::RefCell;

thread_local! {
    /// The locked pictures that were drawn so far, in the order of `locked_names`.
    static LOCKED: RefCell<Vec<Locked>> = const { RefCell::new(vec![]) };
}

/// The report of `check` on a file, and the pixels of the difference. The words are the
/// name of the picture that it should be, or `*` where the file's name tells it, and the
/// file's name.
///
/// Locked pictures are drawn when they are first needed: the one that it should be, the
/// one that it is, and those of the steps; or all where it may be any.
pub fn check(words: &str, file: &[u8]) -> Reply {
    let (name, file_name) = words.split_once(' ').unwrap_or((words, ""));
    let name = match name {
        "*" => ::check::find_name_in_file_name(file_name, locked_names().into_iter()),
        name => Some(name),
    };
    let hash = ::check::read_png(file).map(|picture| course::hash_picture(&picture.pixels));
    let has_hash = |(_, locked): &(_, u64)| hash.as_ref() == Ok(locked);
    let same = course::locked_hashes().find(has_hash).map(|(name, _)| name);
    let is_needed = |known: &str| {
        let is_expected = name.or(same).is_none_or(|name| name == known);
        is_expected || same == Some(known) || Step::from_name(known).is_some()
    };
    for known in locked_names().into_iter().filter(|known| hash.is_ok() && is_needed(known)) {
        let is_kept =
            LOCKED.with_borrow(|locked| locked.iter().any(|picture| picture.name == known));
        if !is_kept && let Some(picture) = draw_picture(known, SIZE[0]) {
            insert(known, picture);
        }
    }
    LOCKED.with_borrow(|locked| page_answer(::check::check_png(file, file_name, name, locked)))
}

fn insert(name: &str, picture: RgbImage) {
    let order = |name: &str| locked_names().iter().position(|known| *known == name);
    LOCKED.with_borrow_mut(|locked| {
        let index = locked.partition_point(|kept| order(&kept.name) < order(name));
        locked.insert(index, Locked { name: name.to_owned(), picture });
    });
}

/// The answer of `check` as one for the page.
fn page_answer(answer: ::check::Answer) -> Reply {
    let mut fields = vec![("code", answer.code.to_string()), ("text", json::quote(&answer.text))];
    let mut pixels = vec![];
    if let Some(difference) = answer.difference {
        let (width, height) = difference.dimensions();
        fields.push(("size", json::list([width, height])));
        pixels = figures::rgba_bytes(&difference);
    }
    Reply { pixels, ..Reply::from_json_fields(fields) }
}
