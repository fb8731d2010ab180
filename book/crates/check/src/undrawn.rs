//! Finds black or white pixels that form a simple shape. Such a shape may mean that the program
//! never drew these pixels.

use crate::comparison::{Comparison, Pixel};
use std::collections::BTreeSet;

/// The minimum number of wrong pixels of one colour that we describe.
const MIN_DESCRIBED_PIXELS: usize = 100;

/// The minimum number of pixels that a border has to surround.
const MIN_SURROUNDED_PIXELS: usize = 100;

/// The maximum number of rectangles that a sentence names.
const MAX_RECTANGLES: usize = 4;

/// The largest n that we try, both for patterns that repeat every n diagonals and for patterns that
/// repeat every n pixels in reading order.
const LARGEST_PERIOD: u32 = 64;

const BLACK: [u8; 3] = [0; 3];
const WHITE: [u8; 3] = [255; 3];

/// Describes black or white wrong pixels that form a simple shape. The sentence about black pixels
/// may add `as if never drawn`. The sentence about white pixels never adds this phrase, because too
/// much light also makes pixels white.
///
/// Black pixels that form no simple shape are described only if the picture is drawn from a scene,
/// every wrong pixel is black, and the sky has both wrong and right pixels.
pub(crate) fn undrawn_sentence(comparison: &Comparison) -> Option<String> {
    black_pixels_sentence(comparison).or_else(|| white_pixels_sentence(comparison))
}

/// Describes the wrong pixels that are black, and says whether they may be undrawn.
fn black_pixels_sentence(comparison: &Comparison) -> Option<String> {
    let mask = Mask::of_colour_if_common(comparison, BLACK)?;
    let Comparison { wrong, right, target, .. } = comparison;
    let (count, has_scene) = (mask.inside_count(), target.scene.is_some());
    if let Some(Shape { words, cause }) = mask.find_shape() {
        let is_undrawn = match cause {
            ShapeCause::Loop => true,
            ShapeCause::Editor => false,
            ShapeCause::Unknown => wrong.len() == count,
        };
        let simile = if is_undrawn { ", as if never drawn" } else { "" };
        let file = match cause {
            ShapeCause::Loop if has_scene => {
                " Pixels are drawn in steps/step01_rays/src/draw_pixels.rs."
            }
            _ => "",
        };
        return Some(format!("{count} wrong pixels are black{simile}: {words}.{file}"));
    }
    let has_sky = |pixels: &[Pixel]| pixels.iter().any(|pixel| pixel.hit.is_none());
    let is_all = has_scene && wrong.len() == count && has_sky(wrong) && has_sky(right);
    is_all.then(|| format!("All {count} wrong pixels are black, as if never drawn."))
}

/// Describes the wrong pixels that are white. Returns None if these pixels form no simple shape.
fn white_pixels_sentence(comparison: &Comparison) -> Option<String> {
    let mask = Mask::of_colour_if_common(comparison, WHITE)?;
    let Shape { words, .. } = mask.find_shape()?;
    Some(format!("{} wrong pixels are white: {words}.", mask.inside_count()))
}

/// A simple shape of pixels that may be undrawn.
struct Shape {
    words: String,
    cause: ShapeCause,
}

/// The likeliest reason why the pixels of a shape are black.
#[derive(Clone, Copy)]
enum ShapeCause {
    /// A loop in the program left these pixels out.
    Loop,
    /// An editor put a border around a finished picture.
    Editor,
    /// Unclear. The shape consists of several rectangles, which may be undrawn or may be dark
    /// objects. The answer calls them undrawn only if all wrong pixels are black.
    Unknown,
}

/// Whether a pixel belongs to a shape that contains all wrong pixels of a given colour.
#[derive(Clone, Copy, PartialEq)]
enum Membership {
    /// The pixel is wrong and has the given colour, so it belongs to the shape.
    Inside,
    /// The pixel is right and has the given colour, so it may belong to the shape.
    Possible,
    /// The pixel has a different colour, so it doesn't belong to the shape.
    Outside,
}

/// Whether a line of pixels is a column or a row.
#[derive(Clone, Copy)]
enum LineKind {
    Column,
    Row,
}

/// Which pixels in a reader's picture have a given colour.
struct Mask {
    columns: u32,
    rows: u32,
    /// The membership of each pixel, row by row.
    memberships: Vec<Membership>,
}

impl Mask {
    /// Creates the mask for a colour. Returns None if too few wrong pixels have that colour.
    fn of_colour_if_common(comparison: &Comparison, colour: [u8; 3]) -> Option<Self> {
        let has_colour = |pixel: &&Pixel| pixel.yours == colour;
        let count = comparison.wrong.iter().filter(has_colour).count();
        (count >= MIN_DESCRIBED_PIXELS).then(|| Self::of_colour(comparison, colour))
    }

    /// Creates the mask for a colour.
    fn of_colour(comparison: &Comparison, colour: [u8; 3]) -> Self {
        let (columns, rows) = comparison.target.picture.dimensions();
        let mut memberships = vec![Membership::Outside; columns as usize * rows as usize];
        let has_colour = |pixel: &&Pixel| pixel.yours == colour;
        let mut set = |pixels: &[Pixel], membership| {
            for Pixel { position: (i, j), .. } in pixels.iter().filter(has_colour) {
                memberships[*j as usize * columns as usize + *i as usize] = membership;
            }
        };
        set(&comparison.wrong, Membership::Inside);
        set(&comparison.right, Membership::Possible);
        Self { columns, rows, memberships }
    }

    /// The column, row and membership of each pixel.
    fn pixels(&self) -> impl Iterator<Item = (u32, u32, Membership)> {
        let index = |k: usize| k as u32;
        let memberships = self.memberships.iter().enumerate();
        memberships.map(move |(k, membership)| {
            (index(k) % self.columns, index(k) / self.columns, *membership)
        })
    }

    fn inside_positions(&self) -> impl Iterator<Item = (u32, u32)> {
        let inside_pixels =
            self.pixels().filter(|(_, _, membership)| *membership == Membership::Inside);
        inside_pixels.map(|(i, j, _)| (i, j))
    }

    fn inside_count(&self) -> usize {
        self.inside_positions().count()
    }

    /// Whether a shape contains all pixels that are `Inside`, and no pixels that are `Outside`.
    fn fits_shape(&self, contains: impl Fn(u32, u32) -> bool) -> bool {
        self.pixels().all(|(i, j, membership)| match membership {
            Membership::Inside => contains(i, j),
            Membership::Possible => true,
            Membership::Outside => !contains(i, j),
        })
    }

    /// Tries all kinds of shapes that we know, and returns the first shape that fits. Returns None
    /// if no shape fits, or if no pixel is `Outside`, since then the whole picture has one colour.
    fn find_shape(&self) -> Option<Shape> {
        if !self.memberships.contains(&Membership::Outside) {
            return None;
        }
        let shapes = [
            Self::find_border,
            Self::find_column_row_crossings,
            Self::find_whole_columns_and_rows,
            Self::find_rectangles,
            Self::find_periodic_pixels,
            Self::find_periodic_diagonals,
        ];
        shapes.iter().find_map(|find| find(self))
    }

    /// Finds bars on two or more sides of the picture. Bars on all four sides are called a frame.
    fn find_border(&self) -> Option<Shape> {
        let outside_pixels: Vec<_> =
            self.pixels().filter(|(_, _, membership)| *membership == Membership::Outside).collect();
        let first_column = outside_pixels.iter().map(|(i, _, _)| *i).min()?;
        let last_column = outside_pixels.iter().map(|(i, _, _)| *i).max()?;
        let (first_row, last_row) = (outside_pixels.first()?.1, outside_pixels.last()?.1);
        let is_border = |i: u32, j: u32| {
            !((first_column..=last_column).contains(&i) && (first_row..=last_row).contains(&j))
        };
        let sides = [
            ("on the left", first_column),
            ("on the right", self.columns - 1 - last_column),
            ("above", first_row),
            ("below", self.rows - 1 - last_row),
        ];
        let bars: Vec<_> = sides.into_iter().filter(|(_, width)| *width > 0).collect();
        // A single bar doesn't count as a border, because a loop that ends too soon leaves such a
        // bar undrawn. A border also has to surround enough pixels.
        if bars.len() < 2
            || outside_pixels.len() < MIN_SURROUNDED_PIXELS
            || !self.fits_shape(is_border)
        {
            return None;
        }
        let shape = if bars.len() == 4 { "a frame" } else { "bars" };
        let widths: Vec<_> = bars.iter().map(|(side, width)| format!("{width} {side}")).collect();
        // If every bar is one pixel wide, a loop probably left out the outermost rows or columns.
        // Editors add wider borders.
        let is_loop = bars.iter().all(|(_, width)| *width == 1);
        let cause = if is_loop { ShapeCause::Loop } else { ShapeCause::Editor };
        let simile = if is_loop { "" } else { ", as editors add them" };
        let words = format!("{shape}{simile}, in pixels: {}", widths.join(", "));
        Some(Shape { words, cause })
    }

    /// Finds a shape that consists of all crossings of certain columns with certain rows: a
    /// rectangle, for example, or every second row.
    fn find_column_row_crossings(&self) -> Option<Shape> {
        let columns: BTreeSet<_> = self.inside_positions().map(|(i, _)| i).collect();
        let rows: BTreeSet<_> = self.inside_positions().map(|(_, j)| j).collect();
        let is_crossing = |i: u32, j: u32| columns.contains(&i) && rows.contains(&j);
        let fits_shape = self.fits_shape(is_crossing);
        let words = join_columns_and_rows(
            &self.format_lines(LineKind::Column, &columns),
            &self.format_lines(LineKind::Row, &rows),
        )?;
        fits_shape.then_some(Shape { words, cause: ShapeCause::Loop })
    }

    /// Finds a shape that consists of whole columns and whole rows, such as the lines between
    /// tiles.
    fn find_whole_columns_and_rows(&self) -> Option<Shape> {
        let columns: BTreeSet<_> = (0..self.columns).collect();
        let rows: BTreeSet<_> = (0..self.rows).collect();
        let outside_pixels =
            || self.pixels().filter(|(_, _, membership)| *membership == Membership::Outside);
        let kept_columns: BTreeSet<_> = outside_pixels().map(|(i, _, _)| i).collect();
        let kept_rows: BTreeSet<_> = outside_pixels().map(|(_, j, _)| j).collect();
        let fits_shape =
            self.fits_shape(|i, j| !kept_columns.contains(&i) || !kept_rows.contains(&j));
        let columns = &columns - &kept_columns;
        let rows = &rows - &kept_rows;
        if !fits_shape || columns.is_empty() || rows.is_empty() {
            return None;
        }
        let lines = [
            self.format_lines(LineKind::Column, &columns),
            self.format_lines(LineKind::Row, &rows),
        ];
        let words = lines.into_iter().flatten().collect::<Vec<_>>().join(" and ");
        Some(Shape { words, cause: ShapeCause::Loop })
    }

    /// Finds a few rectangles, such as tiles that some threads never drew.
    fn find_rectangles(&self) -> Option<Shape> {
        let mut remaining_memberships = self.memberships.clone();
        let index = |i: u32, j: u32| (j * self.columns + i) as usize;
        let mut words = vec![];
        while let Some(first) =
            remaining_memberships.iter().position(|membership| *membership == Membership::Inside)
        {
            if words.len() == MAX_RECTANGLES {
                return None;
            }
            let (left, top) = (first as u32 % self.columns, first as u32 / self.columns);
            let is_inside = |i, j| remaining_memberships[index(i, j)] == Membership::Inside;
            let right = (left..self.columns).take_while(|i| is_inside(*i, top)).last()?;
            let is_row = |j: &u32| (left..=right).all(|i| is_inside(i, *j));
            let bottom = (top..self.rows).take_while(is_row).last()?;
            for j in top..=bottom {
                remaining_memberships[index(left, j)..=index(right, j)].fill(Membership::Possible);
            }
            let [columns, rows] = [left..=right, top..=bottom].map(BTreeSet::from_iter);
            words.push(join_columns_and_rows(
                &self.format_lines(LineKind::Column, &columns),
                &self.format_lines(LineKind::Row, &rows),
            )?);
        }
        let cause = if words.len() == 1 { ShapeCause::Loop } else { ShapeCause::Unknown };
        Some(Shape { words: words.join(", and "), cause })
    }

    /// Finds a pattern of pixels that repeats in reading order, such as every 3rd pixel.
    fn find_periodic_pixels(&self) -> Option<Shape> {
        let number = |i: u32, j: u32| j * self.columns + i;
        let (period, remainders) = self.find_period(number)?;
        let pixels = format_period("pixel", period, remainders.len());
        let words = format!("{pixels}, counted row by row");
        Some(Shape { words, cause: ShapeCause::Loop })
    }

    /// Finds a pattern of diagonals that repeats, such as every 5th diagonal.
    fn find_periodic_diagonals(&self) -> Option<Shape> {
        let describe = |direction: &str, (period, remainders): (u32, BTreeSet<u32>)| {
            let diagonals = format_period("diagonal", period, remainders.len());
            let words = format!("{diagonals}, {direction}");
            Shape { words, cause: ShapeCause::Loop }
        };
        // Add the number of rows, because the difference i − j may be negative.
        let falling = self.find_period(|i, j| i + self.rows - j);
        let rising = || self.find_period(|i, j| i + j);
        falling
            .map(|pattern| describe("falling to the right", pattern))
            .or_else(|| rising().map(|pattern| describe("rising to the right", pattern)))
    }

    /// Looks for a shape that repeats. Such a shape has a period and a set of remainders: `number`
    /// gives each pixel a number, and a pixel belongs to the shape if its number modulo the period
    /// is one of the remainders. Returns the smallest period for which such a shape fits the mask,
    /// and the set of remainders.
    fn find_period(&self, number: impl Fn(u32, u32) -> u32) -> Option<(u32, BTreeSet<u32>)> {
        let numbers: Vec<_> = self.inside_positions().map(|(i, j)| number(i, j)).collect();
        (2..=LARGEST_PERIOD).find_map(|period| {
            let remainders: BTreeSet<_> = numbers.iter().map(|number| number % period).collect();
            let fits_shape = self.fits_shape(|i, j| remainders.contains(&(number(i, j) % period)));
            fits_shape.then_some((period, remainders))
        })
    }

    /// Describes rows or columns. Examples are `row 3`, `rows 3 to 9` and `every 2nd row from 1 to
    /// 359`. Returns None if `lines` is empty, or if `lines` contains every row or every column of
    /// the picture.
    fn format_lines(&self, kind: LineKind, lines: &BTreeSet<u32>) -> Option<String> {
        let (word, total_count) = match kind {
            LineKind::Column => ("column", self.columns),
            LineKind::Row => ("row", self.rows),
        };
        let (first, last) = (lines.first()?, lines.last()?);
        let mut steps = lines.iter().zip(lines.iter().skip(1)).map(|(line, next)| next - line);
        let step = steps.next().unwrap_or(1);
        Some(match (lines.len(), steps.all(|next_step| next_step == step)) {
            (count, _) if count == total_count as usize => return None,
            (1, _) => format!("{word} {first}"),
            (_, true) if step == 1 => format!("{word}s {first} to {last}"),
            (_, true) => format!("every {} {word} from {first} to {last}", format_ordinal(step)),
            (count, false) => format!("{count} {word}s between {first} and {last}"),
        })
    }
}

/// Joins the descriptions of columns and rows, as in `columns 3 to 9 of row 2`. Returns None if
/// both are None.
fn join_columns_and_rows(columns: &Option<String>, rows: &Option<String>) -> Option<String> {
    let descriptions: Vec<_> = [columns, rows].into_iter().flatten().map(String::as_str).collect();
    (!descriptions.is_empty()).then(|| descriptions.join(" of "))
}

/// Describes a pattern that repeats, such as `every 3rd pixel`. If each period contains several
/// pixels, the description is of the form `2 of every 5 pixels`.
fn format_period(pixel_or_diagonal: &str, period: u32, count_per_period: usize) -> String {
    match count_per_period {
        1 => format!("every {} {pixel_or_diagonal}", format_ordinal(period)),
        count => format!("{count} of every {period} {pixel_or_diagonal}s"),
    }
}

fn format_ordinal(number: u32) -> String {
    let end = match (number % 10, number % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{number}{end}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mask_with_ten_rows(columns: u32, contains: impl Fn(u32, u32) -> bool) -> Mask {
        let pixels = (0..10).flat_map(|j| (0..columns).map(move |i| (i, j)));
        let membership = |(i, j)| match contains(i, j) {
            true => Membership::Inside,
            false => Membership::Outside,
        };
        Mask { columns, rows: 10, memberships: pixels.map(membership).collect() }
    }

    #[test]
    fn rows_and_columns_are_described_by_the_first_the_last_and_the_step() {
        let mask = mask_with_ten_rows(12, |_, _| true);
        let format =
            |kind, lines: &[u32]| mask.format_lines(kind, &lines.iter().copied().collect());
        assert_eq!(format(LineKind::Row, &[3]).as_deref(), Some("row 3"));
        assert_eq!(format(LineKind::Row, &[3, 4, 5]).as_deref(), Some("rows 3 to 5"));
        assert_eq!(
            format(LineKind::Column, &[1, 4, 7]).as_deref(),
            Some("every 3rd column from 1 to 7")
        );
        assert_eq!(format(LineKind::Row, &[1, 2, 4]).as_deref(), Some("3 rows between 1 and 4"));
        assert_eq!(format(LineKind::Row, &[]), None);
        let all: Vec<_> = (0..10).collect();
        assert_eq!(format(LineKind::Row, &all), None);
        assert_eq!(format(LineKind::Column, &all).as_deref(), Some("columns 0 to 9"));
    }

    #[test]
    fn ordinals_end_as_in_english() {
        let ordinals = [1, 2, 3, 4, 11, 12, 13, 21, 22, 23, 111, 112].map(format_ordinal);
        let expected = [
            "1st", "2nd", "3rd", "4th", "11th", "12th", "13th", "21st", "22nd", "23rd", "111th",
            "112th",
        ];
        assert_eq!(ordinals, expected);
    }

    #[test]
    fn period_is_an_ordinal_unless_it_contains_several_pixels() {
        assert_eq!(format_period("pixel", 3, 1), "every 3rd pixel");
        assert_eq!(format_period("pixel", 5, 2), "2 of every 5 pixels");
    }

    #[test]
    fn shape_is_the_first_that_fits() {
        let words = |contains: fn(u32, u32) -> bool| {
            mask_with_ten_rows(12, contains).find_shape().map(|shape| shape.words)
        };
        assert_eq!(words(|_, _| true), None);
        assert_eq!(words(|_, j| j == 4).as_deref(), Some("row 4"));
        assert_eq!(words(|i, j| i < 3 && j > 7).as_deref(), Some("columns 0 to 2 of rows 8 to 9"));
        let lines = "every 4th column from 3 to 11 and every 5th row from 4 to 9";
        assert_eq!(words(|i, j| i % 4 == 3 || j % 5 == 4).as_deref(), Some(lines));
        let two = "columns 0 to 1 of row 0, and columns 5 to 6 of row 7";
        assert_eq!(
            words(|i, j| (i < 2 && j == 0) || ((5..7).contains(&i) && j == 7)).as_deref(),
            Some(two)
        );
        let pixels = "every 7th pixel, counted row by row";
        assert_eq!(words(|i, j| (12 * j + i) % 7 == 2).as_deref(), Some(pixels));
        let wide = mask_with_ten_rows(40, |i, j| (i + 10 - j) % 5 == 1).find_shape();
        let falling = "every 5th diagonal, falling to the right";
        assert!(wide.is_some_and(|shape| shape.words == falling));
        assert_eq!(words(|i, j| (i * i + 3 * j) % 11 == 0), None);
    }
}
