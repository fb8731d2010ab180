use image::RgbImage;
use image::imageops::{FilterType, resize};

/// What was made of ours that has another size: half a sentence, if that explains the
/// picture. `drawn` is our own at the picture's size.
pub(crate) fn part(
    yours: &RgbImage,
    ours: &RgbImage,
    drawn: Option<&RgbImage>,
) -> Option<String> {
    let (w, h) = yours.dimensions();
    if let Some((i, j)) = found(yours, ours) {
        let (right, low) = (i + w - 1, j + h - 1);
        return Some(format!(
            "cut out: its columns {i} to {right} and rows {j} to {low}"
        ));
    }
    if let Some((i, j)) = found(ours, yours) {
        return Some(format!(
            "inside a larger picture, perhaps a screenshot, from column {i} and row {j} on"
        ));
    }
    let is_likely = w * h <= 4 * ours.width() * ours.height();
    (is_likely && is_scaled(yours, ours, drawn)).then(|| {
        let (from, to) = ours.dimensions();
        format!("scaled, {from}×{to} pixels made into {w}×{h}")
    })
}

/// The corner of the place in `whole` where all pixels of `part` stand.
fn found(part: &RgbImage, whole: &RgbImage) -> Option<(u32, u32)> {
    let (w, h) = part.dimensions();
    let columns = whole.width().checked_sub(w)?;
    let rows = whole.height().checked_sub(h)?;
    // A part of one colour is found too often.
    let first = part.get_pixel_checked(0, 0)?;
    if part.pixels().filter(|pixel| *pixel != first).count() < 16 {
        return None;
    }
    let is_at = |&(i, j): &(u32, u32)| {
        let mut pixels = part.enumerate_pixels();
        pixels.all(|(k, l, pixel)| pixel == whole.get_pixel(i + k, j + l))
    };
    (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j))).find(is_at)
}

/// Whether the picture is nearer to ours scaled than to what is drawn at its size.
fn is_scaled(yours: &RgbImage, ours: &RgbImage, drawn: Option<&RgbImage>) -> bool {
    let (w, h) = yours.dimensions();
    let apart = |other: &RgbImage| {
        let bytes = yours.as_raw().iter().zip(other.as_raw());
        let sum: u64 = bytes.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
        sum as f64 / yours.as_raw().len().max(1) as f64
    };
    let filters = [FilterType::Nearest, FilterType::Triangle, FilterType::Lanczos3];
    let scaled = filters.map(|filter| apart(&resize(ours, w, h, filter)));
    let least = scaled.into_iter().fold(f64::INFINITY, f64::min);
    least < 1.0 && drawn.is_none_or(|drawn| least < apart(drawn) / 2.0)
}
