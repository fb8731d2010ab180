use crate::evidence::Evidence;
use crate::explanation::Explanation;
use image::RgbImage;
use std::rc::Rc;

const CAMERA: &str = "step01_rays/camera.rs";
const RENDER: &str = "step01_rays/render.rs";
const RGB8: &str = "step01_rays/rgb8.rs";

/// The place in ours of a place in the picture, of a picture of so many columns and rows.
type Turn = fn(u32, u32, u32, u32) -> (u32, u32);

const TURNS: [(&str, Turn); 8] = [
    ("", |i, j, _, _| (i, j)),
    (" upside down", |i, j, _, h| (i, h - 1 - j)),
    (" mirrored, left for right", |i, j, w, _| (w - 1 - i, j)),
    (" turned half around", |i, j, w, h| (w - 1 - i, h - 1 - j)),
    (" transposed, its rows as columns", |i, j, _, _| (j, i)),
    (" turned a quarter to the right", |i, j, w, _| (j, w - 1 - i)),
    (" turned a quarter to the left", |i, j, _, h| (h - 1 - j, i)),
    (" transposed and turned", |i, j, w, h| (h - 1 - j, w - 1 - i)),
];

/// The orders of red, green and blue.
const ORDERS: [(&str, [usize; 3]); 6] = [
    ("", [0, 1, 2]),
    (", with red and blue swapped", [2, 1, 0]),
    (", with red and green swapped", [1, 0, 2]),
    (", with green and blue swapped", [0, 2, 1]),
    (", with green, blue, red for red, green, blue", [1, 2, 0]),
    (", with blue, red, green for red, green, blue", [2, 0, 1]),
];

/// Our picture as a function from columns and rows.
#[derive(Clone)]
pub(crate) struct OurPicture<'a> {
    /// Columns and rows.
    pub size: (u32, u32),
    /// The colour in a column and a row.
    pub colour: Rc<dyn Fn(u32, u32) -> [u8; 3] + 'a>,
}

impl<'a> OurPicture<'a> {
    /// One that has been drawn.
    pub fn from_drawn(picture: &'a RgbImage) -> Self {
        let colour = Rc::new(|i, j| picture.get_pixel(i, j).0);
        Self { size: picture.dimensions(), colour }
    }
}

/// Explanations, not yet tried: ours turned, mirrored, with its channels in another order.
pub(crate) fn turned_candidates<'a>(
    evidence: &Evidence,
    ours: OurPicture<'a>,
) -> impl Iterator<Item = Explanation<'a>> {
    let (size @ (w, h), name) = (evidence.yours.size, evidence.name.to_owned());
    let turns = TURNS
        .into_iter()
        .enumerate()
        .filter(move |(k, _)| ours.size == if *k < 4 { size } else { (h, w) });
    let colour = ours.colour;
    turns.flat_map(move |(_, (turned, turn))| {
        let orders = ORDERS
            .into_iter()
            .filter(move |(swapped, _)| !turned.is_empty() || !swapped.is_empty());
        let (name, colour) = (name.clone(), colour.clone());
        orders.map(move |(swapped, order)| {
            let sentence =
                format!("Your picture is that of {name}{turned}{swapped}.");
            let file = if turned.is_empty() { RGB8 } else { CAMERA };
            let colour = colour.clone();
            let mut explanation =
                Explanation::exact(sentence, &[file], move |pixel| {
                    let (i, j) = turn(pixel.i, pixel.j, w, h);
                    let colour = colour(i, j);
                    order.map(|k| colour[k])
                });
            // A mirrored ray may differ in its last bit.
            explanation.exceptions = 500;
            explanation
        })
    })
}

/// Explanations, not yet tried: the bytes of ours in other places, as in a buffer of
/// another layout.
pub(crate) fn rearranged_candidates<'a>(
    evidence: &'a Evidence,
    ours: &'a RgbImage,
) -> Vec<Explanation<'a>> {
    if ours.dimensions() != evidence.yours.size || !evidence.has_all_rows() {
        return vec![];
    }
    let (w, h) = ours.dimensions();
    let [w, h] = [w, h].map(|n: u32| n as usize);
    let (count, bytes) = (w * h, ours.as_raw());
    let pixel = move |n: usize| [bytes[3 * n], bytes[3 * n + 1], bytes[3 * n + 2]];
    // From the place of a byte in the picture to the byte.
    let of_bytes = |words: &str, byte: Box<dyn Fn(usize) -> u8 + 'a>| {
        let sentence =
            format!("The bytes of your picture are ours in other places: {words}.");
        Explanation::exact(sentence, &[RENDER, RGB8], move |pixel| {
            let n = pixel.j as usize * w + pixel.i as usize;
            [0, 1, 2].map(|k| byte(3 * n + k))
        })
    };
    // From the number of a pixel in the picture to the pixel.
    let of_pixels = |words: &str, place: Box<dyn Fn(usize) -> usize + 'a>| {
        let sentence = format!(
            "The pixels of your picture are ours in other places: {words}."
        );
        Explanation::exact(sentence, &[RENDER], move |p| {
            pixel(place(p.j as usize * w + p.i as usize) % count)
        })
    };
    let mut all = vec![
        of_pixels(
            "column by column, i·vRes + j for j·hRes + i",
            Box::new(move |n| n % h * w + n / h),
        ),
        of_pixels(
            "read column by column, though they are row by row",
            Box::new(move |n| n % w * h + n / w),
        ),
        of_bytes(
            "first all red, then all green, then all blue",
            Box::new(move |n| bytes[3 * (n % count) + n / count]),
        ),
        of_bytes(
            "in each row first all red, then all green, then all blue",
            Box::new(move |n| {
                bytes[3 * (n / (3 * w) * w + n % w) + n % (3 * w) / w]
            }),
        ),
        of_bytes(
            "read as planes, though red, green and blue of a pixel are together",
            Box::new(move |n| bytes[n % 3 * count + n / 3]),
        ),
    ];
    for (words, order) in
        [("RGBA", [0, 1, 2, 3]), ("BGRA", [2, 1, 0, 3]), ("ARGB", [3, 0, 1, 2])]
    {
        all.push(of_bytes(
            &format!("four bytes a pixel ({words}), taken for three"),
            Box::new(move |n| match order[n % 4] {
                3 => 255,
                k => bytes[3 * (n / 4) + k],
            }),
        ));
    }
    all.push(of_bytes(
        "three bytes a pixel, taken for four, of which the last is left out",
        Box::new(move |n| bytes[(n / 3 * 4 + n % 3) % bytes.len()]),
    ));
    all.extend(find_byte_shifts(evidence, ours).into_iter().map(|shift| {
        let (count, unit) = match shift {
            _ if shift % (3 * w) == 0 => (shift / (3 * w), "rows"),
            _ if shift % 3 == 0 => (shift / 3, "pixels"),
            _ => (shift, "bytes"),
        };
        of_bytes(
            &format!(
                "{count} {unit} late, and what is lost at the end comes first"
            ),
            Box::new(move |n| bytes[(n + bytes.len() - shift) % bytes.len()]),
        )
    }));
    for columns in [1, 2, w / 2, w - 2, w - 1] {
        let words = format!(
            "each row {columns} columns late, and what is lost at its end comes first"
        );
        let place = move |n: usize| n / w * w + (n % w + w - columns) % w;
        all.push(of_pixels(&words, Box::new(place)));
    }
    for stride in [w - 1, w + 1, h, w / 2, w * 2] {
        let sentence = format!(
            "Each row of your picture begins {stride} pixels after the one before it, not \
             {w}."
        );
        // What is written later is seen, and what is never written is black.
        all.push(Explanation::exact(sentence, &[RENDER], move |p| {
            let n = p.j as usize * w + p.i as usize;
            let last = (n / stride).min(h - 1);
            let column = n - last * stride;
            if column < w { pixel(last * w + column) } else { [0; 3] }
        }));
    }
    for (words, row) in [
        (
            "each row is there twice, and the lower half is missing",
            Box::new(|j: usize| j / 2),
        ),
        (
            "each second row is missing, and the rest is there twice",
            Box::new(move |j: usize| 2 * j % h),
        ),
    ] as [(&str, Box<dyn Fn(usize) -> usize>); 2]
    {
        let sentence =
            format!("The rows of your picture are ours in other places: {words}.");
        all.push(Explanation::exact(sentence, &[RENDER], move |p| {
            pixel(row(p.j as usize) * w + p.i as usize)
        }));
    }
    all
}

/// Numbers of bytes by which all may have moved: where a piece of ours is found again.
fn find_byte_shifts(evidence: &Evidence, ours: &RgbImage) -> Vec<usize> {
    let (ours, yours) = (ours.as_raw(), evidence.yours.pixels.as_raw());
    let piece_at = |start: usize| ours.get(start..start + 96);
    let middle = ours.len() / 2;
    let distinct = |start: &usize| {
        let piece = piece_at(*start).unwrap_or_default();
        piece.windows(4).filter(|four| four[0] != four[3]).count()
    };
    let starts = (0..64).map(|k| middle - 96 * k.min(middle / 96));
    let Some(start) = starts.max_by_key(distinct) else { return vec![] };
    let Some(piece) = piece_at(start) else { return vec![] };
    let offsets = yours.windows(piece.len()).enumerate();
    let offsets = offsets.filter(|(at, window)| *at != start && *window == piece);
    offsets.take(4).map(|(at, _)| (at + ours.len() - start) % ours.len()).collect()
}

/// Whether many pixels are wrong, and these have the colours of ours at other places.
pub(crate) fn has_our_colours_elsewhere(evidence: &Evidence) -> bool {
    let sorted = |colour: fn(&crate::evidence::Pixel) -> [u8; 3]| {
        let mut all: Vec<_> = evidence.wrong_pixels().iter().map(colour).collect();
        all.sort_unstable();
        all
    };
    let is_much = evidence.pixels.len() / 50 < evidence.wrong_pixels().len();
    is_much && sorted(|pixel| pixel.yours) == sorted(|pixel| pixel.ours)
}
