use crate::Picture;
use image::RgbImage;
use image::imageops::{FilterType, resize};

/// How many places are compared pixel by pixel for a part that seems to be there.
const MOST_PLACES: usize = 32;

/// Half a sentence: which part or scaled copy of ours it is, if that explains the
/// picture. `ours_at_size` is our own at the picture's size.
pub(crate) fn crop_or_scale_clause(
    yours: &Picture,
    ours: &RgbImage,
    ours_at_size: Option<&RgbImage>,
) -> Option<String> {
    if !yours.has_all_rows() || yours.size == ours.dimensions() {
        return None;
    }
    let yours = &yours.pixels;
    let (w, h) = yours.dimensions();
    if let Some((i, j)) = find_corner_of_part(yours, ours) {
        let (right, low) = (i + w - 1, j + h - 1);
        return Some(format!(
            "cut out: its columns {i} to {right} and rows {j} to {low}"
        ));
    }
    if let Some((i, j)) = find_corner_of_part(ours, yours) {
        return Some(format!(
            "inside a larger picture, perhaps a screenshot, from column {i} and row {j} on"
        ));
    }
    let is_likely = w * h <= 9 * ours.width() * ours.height();
    (is_likely && is_scaled_copy(yours, ours, ours_at_size)).then(|| {
        let (our_columns, our_rows) = ours.dimensions();
        format!("scaled, {our_columns}×{our_rows} pixels made into {w}×{h}")
    })
}

/// How many columns a piece has that is searched for first.
const PIECE: usize = 16;

/// The corner of the place in `whole` where all pixels of `part` are.
///
/// The piece of a row of `part` that has most colours is searched for, so that where much
/// has one colour little is compared.
fn find_corner_of_part(part: &RgbImage, whole: &RgbImage) -> Option<(u32, u32)> {
    let (w, h) = part.dimensions();
    let columns = whole.width().checked_sub(w)?;
    let rows = whole.height().checked_sub(h)?;
    let row = |picture: &RgbImage, j: u32| {
        let width = 3 * picture.width() as usize;
        let start = j as usize * width;
        start..start + width
    };
    let pieces = (0..h).flat_map(|j| {
        let row = &part.as_raw()[row(part, j)];
        let pieces = row.chunks_exact(3 * PIECE).enumerate();
        pieces.map(move |(k, piece)| (j, 3 * PIECE * k, piece))
    });
    let colours = |piece: &[u8]| {
        piece.windows(6).step_by(3).filter(|two| two[..3] != two[3..]).count()
    };
    let (at_row, at_byte, piece) =
        pieces.max_by_key(|(.., piece)| colours(piece))?;
    if colours(piece) < 2 {
        return None;
    }
    let mut compared = 0;
    for j in 0..=rows {
        let line = &whole.as_raw()[row(whole, j + at_row)];
        for i in 0..=columns {
            let start = 3 * i as usize + at_byte;
            if line[start..start + piece.len()] != *piece {
                continue;
            }
            let is_there = (0..h).all(|l| {
                let line = &whole.as_raw()[row(whole, j + l)];
                let start = 3 * i as usize;
                line[start..start + 3 * w as usize] == part.as_raw()[row(part, l)]
            });
            if is_there {
                return Some((i, j));
            }
            compared += 1;
            if compared == MOST_PLACES {
                return None;
            }
        }
    }
    None
}

/// Whether the picture is nearer to ours scaled than to what is drawn at its size, and
/// nowhere brighter or darker than what is there in ours allows.
fn is_scaled_copy(
    yours: &RgbImage,
    ours: &RgbImage,
    ours_at_size: Option<&RgbImage>,
) -> bool {
    let (w, h) = yours.dimensions();
    let mean_difference = |picture: &RgbImage| {
        let bytes = yours.as_raw().iter().zip(picture.as_raw());
        let sum: u64 = bytes.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        sum as f64 / yours.as_raw().len().max(1) as f64
    };
    let filters = [FilterType::Nearest, FilterType::Triangle, FilterType::Lanczos3];
    let scaled = filters.map(|filter| mean_difference(&resize(ours, w, h, filter)));
    let least_difference = scaled.into_iter().fold(f64::INFINITY, f64::min);
    if 1.0 < least_difference
        || ours_at_size.is_some_and(|ours_at_size| {
            mean_difference(ours_at_size) < least_difference
        })
    {
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
        let places = span(j, y, ours.height());
        let mut range = [[255, 0]; 3];
        for l in places {
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
            low.saturating_sub(overshoot) <= pixel[c]
                && pixel[c] <= high.saturating_add(overshoot)
        })
    })
}
