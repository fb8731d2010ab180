//! Recognises our picture if it was turned, mirrored, cropped or enlarged, or if its channels were
//! swapped. Also recognises pictures of a single colour.

use crate::comparison::{Budget, scattered_positions};
use image::RgbImage;

/// The maximum number of pixels to compare in the search for the reader's picture inside ours.
const MAX_COMPARED_PIXELS: u32 = 1 << 26;

/// The minimum number of pixels in a part of our picture. Smaller parts might match by chance.
const MIN_PIXELS: usize = 100;

/// Maps a position in our picture to the position of the same pixel in the turned picture. The
/// second argument is the position of the last pixel in our picture.
type Orientation = fn((u32, u32), (u32, u32)) -> (u32, u32);

const ORIENTATIONS: [(&str, Orientation); 6] = [
    ("", |position, _| position),
    ("upside down", |(i, j), (_, row)| (i, row - j)),
    ("mirrored left to right", |(i, j), (column, _)| (column - i, j)),
    ("turned by 180°", |(i, j), (column, row)| (column - i, row - j)),
    ("turned by 90° to the right", |(i, j), (_, row)| (row - j, i)),
    ("turned by 90° to the left", |(i, j), (column, _)| (j, column - i)),
];

const CHANNEL_ORDERS: [(&str, [usize; 3]); 4] = [
    ("", [0, 1, 2]),
    ("with red and blue exchanged", [2, 1, 0]),
    ("with red and green exchanged", [1, 0, 2]),
    ("with green and blue exchanged", [0, 2, 1]),
];

/// Describes a picture if it is ours, but turned, mirrored, cropped, enlarged or with channels
/// swapped. Returns None for all other pictures. `title` is a phrase that stands for our picture,
/// such as `the picture of glass`.
pub(crate) fn describe_transformed(
    picture: &RgbImage,
    ours: &RgbImage,
    title: &str,
) -> Option<String> {
    let mut clauses = turned_or_swapped_clauses(picture, ours);
    if clauses.is_empty() {
        clauses.extend(part_or_enlarged_clause(picture, ours));
    }
    let is_ours = !clauses.is_empty();
    is_ours.then(|| format!("This is {title}, {}.", clauses.join(", or ")))
}

/// Describes a picture if all of its pixels have the same colour. Returns None for all other
/// pictures.
pub(crate) fn describe_uniform(picture: &RgbImage) -> Option<String> {
    let [r, g, b] = uniform_colour(picture)?;
    Some(format!("Your picture is one colour, ({r}, {g}, {b}), in all pixels."))
}

/// Returns the colour of the picture if all of its pixels have the same colour.
pub(crate) fn uniform_colour(picture: &RgbImage) -> Option<[u8; 3]> {
    let first_pixel = picture.get_pixel_checked(0, 0)?.0;
    // Compare each pixel with the previous one.
    let bytes = picture.as_raw();
    (bytes[3..] == bytes[..bytes.len() - 3]).then_some(first_pixel)
}

/// Returns a clause, such as `upside down`, for each orientation of our picture that is equal to
/// yours. If the pictures are equal only with two channels exchanged, the clause names these
/// channels, too. If several orders of the channels fit, the first of `CHANNEL_ORDERS` counts.
fn turned_or_swapped_clauses(yours: &RgbImage, ours: &RgbImage) -> Vec<String> {
    if yours.pixels().len() != ours.pixels().len() {
        return vec![];
    }
    let (columns, rows) = ours.dimensions();
    let clauses = ORIENTATIONS.iter().filter_map(|(clause, orientation)| {
        // Several orders may fit: a grey picture looks the same in all of them.
        let (swapped, _) = CHANNEL_ORDERS.iter().find(|(_, order)| {
            scattered_positions((columns, rows)).all(|position| {
                let (i, j) = orientation(position, (columns - 1, rows - 1));
                let colour = order.map(|k| ours[position][k]);
                yours.get_pixel_checked(i, j).is_some_and(|yours| yours.0 == colour)
            })
        })?;
        let words = [*clause, *swapped].into_iter().filter(|words| !words.is_empty());
        Some(words.collect::<Vec<_>>().join(", "))
    });
    clauses.collect()
}

/// Returns a clause, such as `enlarged 2 times`, in two cases: your picture is a part of our
/// picture, or your picture is our whole picture, enlarged.
fn part_or_enlarged_clause(yours: &RgbImage, ours: &RgbImage) -> Option<String> {
    let ((w, h), (columns, rows)) = (yours.dimensions(), ours.dimensions());
    if let Some((i, j)) = find_corner(yours, ours) {
        let (right, low) = (i + w - 1, j + h - 1);
        return Some(format!("cut out: its columns {i} to {right} and rows {j} to {low}"));
    }
    let times = w / columns;
    let is_enlarged = (w, h) == (times * columns, times * rows)
        && yours.enumerate_pixels().all(|(i, j, pixel)| ours[(i / times, j / times)] == *pixel);
    is_enlarged.then(|| format!("enlarged {times} times"))
}

/// Finds the column and row in `whole` at which `part` begins. Returns None if `part` doesn't occur
/// in `whole`, if `part` is too small to be recognised, or if the budget runs out.
fn find_corner(part: &RgbImage, whole: &RgbImage) -> Option<(u32, u32)> {
    let (w, h) = part.dimensions();
    let (columns, rows) = (whole.width().checked_sub(w)?, whole.height().checked_sub(h)?);
    if !(MIN_PIXELS..whole.pixels().len()).contains(&part.pixels().len()) {
        return None;
    }
    let mut positions: Vec<_> = scattered_positions((w, h)).collect();
    let budget = Budget::new(MAX_COMPARED_PIXELS);
    let mut corners = (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j)));
    corners.find(|(i, j)| {
        let is_there = |(k, l): &(u32, u32)| part[(*k, *l)] == whole[(i + k, j + l)];
        budget.holds_for_all(&mut positions, 1, is_there)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture in which no two pixels have the same colour.
    fn numbered_picture(columns: u32, rows: u32) -> RgbImage {
        RgbImage::from_fn(columns, rows, |i, j| [i as u8, j as u8, 200].into())
    }

    #[test]
    fn turned_mirrored_or_recoloured_picture_is_described() {
        use image::imageops::{flip_horizontal, flip_vertical, rotate90, rotate180, rotate270};
        let ours = numbered_picture(20, 10);
        let clauses = |yours: &RgbImage| turned_or_swapped_clauses(yours, &ours);
        assert_eq!(clauses(&ours), [""]);
        assert_eq!(clauses(&flip_vertical(&ours)), ["upside down"]);
        assert_eq!(clauses(&flip_horizontal(&ours)), ["mirrored left to right"]);
        assert_eq!(clauses(&rotate180(&ours)), ["turned by 180°"]);
        assert_eq!(clauses(&rotate90(&ours)), ["turned by 90° to the right"]);
        assert_eq!(clauses(&rotate270(&ours)), ["turned by 90° to the left"]);
        let swapped = RgbImage::from_fn(20, 10, |i, j| {
            let [r, g, b] = ours[(i, 9 - j)].0;
            [g, r, b].into()
        });
        assert_eq!(clauses(&swapped), ["upside down, with red and green exchanged"]);
        assert!(clauses(&numbered_picture(10, 20)).is_empty());
    }

    #[test]
    fn part_is_described_by_its_position_and_enlarged_picture_by_its_factor() {
        let ours = numbered_picture(20, 10);
        let clause = |yours: &RgbImage| part_or_enlarged_clause(yours, &ours);
        let part = RgbImage::from_fn(15, 7, |i, j| ours[(i + 4, j + 2)]);
        let words = "cut out: its columns 4 to 18 and rows 2 to 8";
        assert_eq!(clause(&part).as_deref(), Some(words));
        // This part has 99 pixels, one too few.
        assert_eq!(clause(&RgbImage::from_fn(11, 9, |i, j| ours[(i, j)])), None);
        let enlarged = RgbImage::from_fn(60, 30, |i, j| ours[(i / 3, j / 3)]);
        assert_eq!(clause(&enlarged).as_deref(), Some("enlarged 3 times"));
        assert_eq!(clause(&RgbImage::from_fn(60, 20, |i, j| ours[(i / 3, j / 2)])), None);
    }

    #[test]
    fn uniform_colour_is_found_if_no_pixel_differs() {
        let mut picture = RgbImage::from_pixel(3, 2, [1, 2, 3].into());
        assert_eq!(uniform_colour(&picture), Some([1, 2, 3]));
        picture[(2, 1)] = [1, 2, 4].into();
        assert_eq!(uniform_colour(&picture), None);
        assert_eq!(uniform_colour(&RgbImage::new(0, 0)), None);
    }
}
