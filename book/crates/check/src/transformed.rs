use crate::Picture;
use image::RgbImage;
use image::imageops;

/// How many places are compared pixel by pixel for a part that seems to be there.
const MOST_PLACES: usize = 32;

/// How many columns a piece has that is searched for first.
const PIECE: u32 = 16;

/// A picture turned or mirrored.
type Turn = fn(&RgbImage) -> RgbImage;

const TURNS: [(&str, Turn); 8] = [
    ("", RgbImage::clone),
    ("upside down", imageops::flip_vertical),
    ("mirrored left to right", imageops::flip_horizontal),
    ("turned by 180°", imageops::rotate180),
    ("turned by 90° to the right", imageops::rotate90),
    ("turned by 90° to the left", imageops::rotate270),
    ("with rows and columns exchanged", |ours| {
        imageops::flip_horizontal(&imageops::rotate90(ours))
    }),
    ("with rows and columns exchanged, and turned by 180°", |ours| {
        imageops::flip_vertical(&imageops::rotate90(ours))
    }),
];

/// The orders of red, green and blue.
const ORDERS: [(&str, [usize; 3]); 6] = [
    ("", [0, 1, 2]),
    ("with red and blue exchanged", [2, 1, 0]),
    ("with red and green exchanged", [1, 0, 2]),
    ("with green and blue exchanged", [0, 2, 1]),
    ("with green, blue, red instead of red, green, blue", [1, 2, 0]),
    ("with blue, red, green instead of red, green, blue", [2, 0, 1]),
];

/// Clauses such as `upside down`: all of how yours is the whole of ours turned, mirrored or
/// with its channels in another order.
pub(crate) fn turned_or_swapped_clauses(yours: &RgbImage, ours: &RgbImage) -> Vec<String> {
    let mut clauses = vec![];
    for (turned, turn) in TURNS {
        let ours = turn(ours);
        if ours.dimensions() != yours.dimensions() {
            continue;
        }
        for (swapped, order) in ORDERS {
            let mut pairs = yours.pixels().zip(ours.pixels());
            if pairs.all(|(yours, ours)| yours.0 == order.map(|k| ours.0[k])) {
                let words = [turned, swapped].into_iter().filter(|words| !words.is_empty());
                clauses.push(words.collect::<Vec<_>>().join(", "));
            }
        }
    }
    clauses
}

/// A clause such as `enlarged 2 times`: which part of ours yours is, or ours of yours, or how
/// many times larger each pixel.
pub(crate) fn cut_or_enlarged_clause(picture: &Picture, ours: &RgbImage) -> Option<String> {
    let (yours, (w, h)) = (&picture.rows, picture.size);
    if picture.size == ours.dimensions() {
        return None;
    }
    let is_whole = picture.row_step == 1;
    if is_whole && let Some((i, j)) = find_corner_of_part(yours, ours) {
        let (right, low) = (i + w - 1, j + h - 1);
        return Some(format!("cut out: its columns {i} to {right} and rows {j} to {low}"));
    }
    if is_whole && let Some((i, j)) = find_corner_of_part(ours, yours) {
        let place = format!("from column {i} and row {j} on");
        return Some(format!("inside a larger one, perhaps a screenshot, {place}"));
    }
    let times = w / ours.width();
    let is_size = times * ours.width() == w && times * ours.height() == h;
    let is_enlarged = is_size
        && yours.enumerate_pixels().all(|(i, row, pixel)| {
            ours.get_pixel(i / times, row * picture.row_step / times) == pixel
        });
    is_enlarged.then(|| format!("enlarged {times} times"))
}

/// The corner of the place in `whole` where all pixels of `part` are.
///
/// The piece of a row of `part` that has most colours is searched for, so that where much
/// has one colour little is compared.
fn find_corner_of_part(part: &RgbImage, whole: &RgbImage) -> Option<(u32, u32)> {
    let (w, h) = part.dimensions();
    let columns = whole.width().checked_sub(w)?;
    let rows = whole.height().checked_sub(h)?;
    let row = |picture: &RgbImage, i: u32, j: u32, count: u32| {
        let start = 3 * (j as usize * picture.width() as usize + i as usize);
        start..start + 3 * count as usize
    };
    let is_there = |(i, j): (u32, u32), (k, l): (u32, u32), count: u32| {
        whole.as_raw()[row(whole, i + k, j + l, count)] == part.as_raw()[row(part, k, l, count)]
    };
    let pieces = (0..h).flat_map(|j| (0..w / PIECE).map(move |k| (PIECE * k, j)));
    let colours = |(i, j): &(u32, u32)| {
        let piece = &part.as_raw()[row(part, *i, *j, PIECE)];
        piece.windows(6).step_by(3).filter(|two| two[..3] != two[3..]).count()
    };
    let piece = pieces.max_by_key(colours).filter(|piece| 2 <= colours(piece))?;
    let corners = (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j)));
    corners
        .filter(|corner| is_there(*corner, piece, PIECE))
        .take(MOST_PLACES)
        .find(|corner| (0..h).all(|l| is_there(*corner, (0, l), w)))
}

/// The colour of all pixels, where it is one.
pub(crate) fn uniform_colour(picture: &RgbImage) -> Option<[u8; 3]> {
    let first = picture.get_pixel_checked(0, 0)?;
    picture.pixels().all(|pixel| pixel == first).then_some(first.0)
}
