use crate::pictures::{NAMES, SIZE, SUMS};
use ::check::Locked;
use image::RgbImage;
use live::Answer;
use live::json::{self, Json};
use std::cell::RefCell;
use std::io::Cursor;

thread_local! {
    /// The pictures that were drawn for us, in the order of their names.
    static OURS: RefCell<Vec<Locked>> = const { RefCell::new(vec![]) };
}

/// What `check` says of a PNG file, to the words `NAME FILE`: the name of the picture
/// that it should be, or `*` where the file's name tells it, and the file's name. The
/// pixels are those of the difference.
///
/// Or else the names of pictures of ours to [`keep`] before it can be said. Each takes a
/// while to be drawn: they are asked for only where they matter.
pub fn check(words: &str, file: &[u8]) -> Answer {
    let (name, called) = words.split_once(' ').unwrap_or((words, ""));
    let name = match name {
        "*" => check::by_file(called, NAMES.iter().copied()),
        name => Some(name),
    };
    OURS.with_borrow(|ours| {
        let is_missing = |name: &&str| !ours.iter().any(|one| one.name == *name);
        let its = NAMES.iter().copied().find(|known| Some(*known) == name);
        if let Some(its) = its.filter(is_missing) {
            return missing([its]);
        }
        if let Ok(yours) = check::picture(Cursor::new(file)) {
            let sum = yours.map(|yours| sum(yours.as_raw()));
            let may_be = |k: &usize| its.is_none() || Some(SUMS[*k]) == sum;
            let others = (0..NAMES.len()).filter(may_be).map(|k| NAMES[k]);
            let mut others = others.filter(is_missing).peekable();
            if others.peek().is_some() {
                return missing(others);
            }
        }
        said(check::check(Cursor::new(file), called, name, ours))
    })
}

/// A number that hardly any two pictures share: the remainder by 2¹⁶ of their bytes, as
/// digits of a number to the base 31.
pub fn sum(pixels: &[u8]) -> u16 {
    let add =
        |sum: u16, byte: &u8| sum.wrapping_mul(31).wrapping_add((*byte).into());
    pixels.iter().fold(0, add)
}

/// Keeps a picture of ours: red, green and blue of each pixel.
///
/// # Panics
///
/// Panics where it has another size: then it is of another module than this, and would be
/// asked for again and again.
pub fn keep(name: &str, pixels: &[u8]) -> Answer {
    let [columns, rows] = SIZE;
    let picture = RgbImage::from_raw(columns, rows, pixels.to_vec());
    let picture = picture.expect("all pixels of a picture of ours");
    let place = |name: &str| NAMES.iter().position(|known| *known == name);
    OURS.with_borrow_mut(|ours| {
        let at = ours.partition_point(|one| place(&one.name) < place(name));
        ours.insert(at, Locked { name: name.to_owned(), picture });
    });
    Answer { text: "{}".to_owned(), pixels: vec![] }
}

/// Asks for pictures of ours.
fn missing<'a>(names: impl IntoIterator<Item = &'a str>) -> Answer {
    let names = Json::list(names.into_iter().map(Json::from));
    Answer { text: json::object([("draw", names)]), pixels: vec![] }
}

/// An answer for the page.
fn said(answer: check::Answer) -> Answer {
    let mut fields =
        vec![("code", u32::from(answer.code).into()), ("text", answer.text.into())];
    let mut pixels = vec![];
    if let Some(difference) = answer.difference {
        let (width, height) = difference.dimensions();
        let size = [width, height].map(Json::from);
        fields.push(("size", Json::list(size)));
        pixels = live::rgba(&difference);
    }
    Answer { text: json::object(fields), pixels }
}
