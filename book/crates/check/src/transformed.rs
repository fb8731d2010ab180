use image::RgbImage;
use image::imageops::{self, FilterType, resize};

/// How many places are compared pixel by pixel for a part that seems to be there.
const MOST_PLACES: usize = 32;

/// How many columns a piece has that is searched for first.
const PIECE: u32 = 16;

/// A picture turned or mirrored.
type Turn = fn(&RgbImage) -> RgbImage;

const TURNS: [(&str, Turn); 8] = [
    ("", RgbImage::clone),
    (" upside down", imageops::flip_vertical),
    (" mirrored, left for right", imageops::flip_horizontal),
    (" turned half around", imageops::rotate180),
    (" turned a quarter to the right", imageops::rotate90),
    (" turned a quarter to the left", imageops::rotate270),
    (" transposed, its rows as columns", |ours| {
        imageops::flip_horizontal(&imageops::rotate90(ours))
    }),
    (" transposed and turned", |ours| imageops::flip_vertical(&imageops::rotate90(ours))),
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

/// What is said of a picture that is ours turned, mirrored or with its channels in another
/// order, and the file to go back to.
pub(crate) fn turned_or_swapped_clause(
    yours: &RgbImage,
    ours: &RgbImage,
) -> Option<(String, &'static str)> {
    let count_differing = |ours: &RgbImage, order: [usize; 3]| {
        let pairs = yours.pixels().zip(ours.pixels());
        pairs.filter(|(yours, ours)| yours.0 != order.map(|k| ours.0[k])).count()
    };
    let is_size = |ours: &RgbImage| ours.dimensions() == yours.dimensions();
    let all = yours.pixels().len();
    let wrong = if is_size(ours) { count_differing(ours, [0, 1, 2]) } else { all };
    for (turned_words, turn) in TURNS {
        let turned = turn(ours);
        for (swapped_words, order) in ORDERS.iter().filter(|_| is_size(&turned)) {
            // A mirrored ray may differ in its last bit.
            let end = match count_differing(&turned, *order) {
                0 => String::new(),
                count if count <= (all / 500).min(wrong / 100) => {
                    format!(" in all but {count} pixels")
                }
                _ => continue,
            };
            let file = match turned_words {
                "" => "step01_rays/rgb8.rs",
                _ => "step01_rays/camera.rs",
            };
            return Some((format!("{turned_words}{swapped_words}{end}"), file));
        }
    }
    None
}

/// Half a sentence: which part or scaled copy of ours it is, if that explains the
/// picture. `ours_at_size` is our own at the picture's size.
pub(crate) fn crop_or_scale_clause(
    yours: &RgbImage,
    ours: &RgbImage,
    ours_at_size: Option<&RgbImage>,
) -> Option<String> {
    if yours.dimensions() == ours.dimensions() {
        return None;
    }
    let (w, h) = yours.dimensions();
    if let Some((i, j)) = find_corner_of_part(yours, ours) {
        let (right, low) = (i + w - 1, j + h - 1);
        return Some(format!(", cut out: its columns {i} to {right} and rows {j} to {low}"));
    }
    if let Some((i, j)) = find_corner_of_part(ours, yours) {
        return Some(format!(
            ", inside a larger picture, perhaps a screenshot, from column {i} and row {j} on"
        ));
    }
    let (our_columns, our_rows) = ours.dimensions();
    let is_scaled =
        w * h <= 9 * our_columns * our_rows && is_scaled_copy(yours, ours, ours_at_size);
    is_scaled.then(|| format!(", scaled, {our_columns}×{our_rows} pixels made into {w}×{h}"))
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

/// Whether the picture is nearer to ours scaled than to what is drawn at its size, and
/// nowhere brighter or darker than what is there in ours allows.
fn is_scaled_copy(yours: &RgbImage, ours: &RgbImage, ours_at_size: Option<&RgbImage>) -> bool {
    let (w, h) = yours.dimensions();
    let mean_difference = |picture: &RgbImage| {
        let bytes = yours.as_raw().iter().zip(picture.as_raw());
        let sum: u64 = bytes.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        sum as f64 / yours.as_raw().len().max(1) as f64
    };
    let filters = [FilterType::Nearest, FilterType::Triangle, FilterType::Lanczos3];
    let scaled = filters.map(|filter| mean_difference(&resize(ours, w, h, filter)));
    let least_difference = scaled.into_iter().fold(f64::INFINITY, f64::min);
    let drawn = ours_at_size.map_or(f64::INFINITY, mean_difference);
    if 1.0 < least_difference || drawn < least_difference {
        return false;
    }
    let [x, y] = [(ours.width(), w), (ours.height(), h)]
        .map(|(ours, yours)| f64::from(ours) / f64::from(yours));
    yours.enumerate_pixels().all(|(i, j, pixel)| {
        let span = |k: u32, scale: f64, end: u32| {
            let reach = 3.0 * scale.max(1.0);
            let middle = (f64::from(k) + 0.5) * scale - 0.5;
            let low = (middle - reach).floor().max(0.0) as u32;
            low..=((middle + reach).ceil() as u32).min(end - 1)
        };
        let mut range = [[255, 0]; 3];
        for l in span(j, y, ours.height()) {
            for k in span(i, x, ours.width()) {
                for (c, [low, high]) in range.iter_mut().enumerate() {
                    let byte = ours.get_pixel(k, l)[c];
                    (*low, *high) = ((*low).min(byte), (*high).max(byte));
                }
            }
        }
        // A sharp filter goes beyond its neighbours.
        (0..3).all(|c| {
            let [low, high] = range[c];
            let overshoot = 3 + (high - low) / 4;
            low.saturating_sub(overshoot) <= pixel[c] && pixel[c] <= high.saturating_add(overshoot)
        })
    })
}
