//! Black or white pixels, as they are where a program draws nothing.

use crate::comparison::{Comparison, Pixel};
use std::collections::BTreeSet;

/// The least pixels that count as undrawn, or as a picture with a border.
const LEAST_PIXELS: usize = 100;

/// The most rectangles that a sentence names.
const MOST_RECTANGLES: usize = 4;

/// The largest distance of lines, or of pixels in reading order, that counts as a pattern.
const LARGEST_PERIOD: u32 = 64;

const COLOURS: [(&str, [u8; 3]); 2] = [("black", [0; 3]), ("white", [255; 3])];

/// A sentence about wrong pixels that are black or white and have a plain shape, as those do that
/// nothing draws; or any shape, if all others are right, and a part of the sky is.
pub(crate) fn undrawn_sentence(comparison: &Comparison) -> Option<String> {
    COLOURS.into_iter().find_map(|(name, colour)| {
        let mask = Mask::new(comparison, colour);
        if mask.count() < LEAST_PIXELS {
            return None;
        }
        let plain = plain_shape_sentence(comparison, name, &mask);
        let is_sky = |pixel: &Pixel| pixel.hit.is_none();
        let has_sky = [&comparison.wrong, &comparison.right].map(|all| all.iter().any(is_sky));
        plain.or_else(|| {
            let Comparison { wrong, target, .. } = comparison;
            let is_all = target.drawing.is_some() && wrong.len() == mask.count();
            (is_all && has_sky == [true; 2])
                .then(|| format!("All {} wrong pixels are {name}, as if never drawn.", wrong.len()))
        })
    })
}

fn plain_shape_sentence(comparison: &Comparison, name: &str, mask: &Mask) -> Option<String> {
    let (count, Shape { words, drawn_by_program }) = (mask.count(), mask.find_shape()?);
    let is_program = drawn_by_program && comparison.target.drawing.is_some();
    let file = " Pixels are drawn in steps/step01_rays/src/draw_pixels.rs.";
    let file = if is_program { file } else { "" };
    let simile = if drawn_by_program { ", as if never drawn" } else { "" };
    Some(format!("{count} wrong pixels are {name}{simile}: {words}.{file}"))
}

/// A plain shape of undrawn pixels.
struct Shape {
    words: String,
    /// Whether loops of a program leave it out, rather than an editor around a picture.
    drawn_by_program: bool,
}

/// What a pixel says of a shape.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// Wrong, and of the colour: in the shape.
    Inside,
    /// Right, and of the colour all the same.
    Either,
    /// Of another colour: not in the shape.
    Outside,
}

/// The pixels of one colour in a reader's picture.
struct Mask {
    columns: u32,
    rows: u32,
    /// All pixels, row by row.
    places: Vec<Place>,
}

impl Mask {
    fn new(comparison: &Comparison, colour: [u8; 3]) -> Self {
        let (columns, rows) = comparison.target.picture.dimensions();
        let mut places = vec![Place::Outside; columns as usize * rows as usize];
        let has_colour = |pixel: &&Pixel| pixel.yours == colour;
        let mut set = |pixels: &[Pixel], place| {
            for Pixel { place: (i, j), .. } in pixels.iter().filter(has_colour) {
                places[*j as usize * columns as usize + *i as usize] = place;
            }
        };
        set(&comparison.wrong, Place::Inside);
        set(&comparison.right, Place::Either);
        Self { columns, rows, places }
    }

    /// Column, row and place of each pixel.
    fn pixels(&self) -> impl Iterator<Item = (u32, u32, Place)> {
        let index = |k: usize| k as u32;
        let places = self.places.iter().enumerate();
        places.map(move |(k, place)| (index(k) % self.columns, index(k) / self.columns, *place))
    }

    fn inside(&self) -> impl Iterator<Item = (u32, u32)> {
        let inside = self.pixels().filter(|(_, _, place)| *place == Place::Inside);
        inside.map(|(i, j, _)| (i, j))
    }

    fn count(&self) -> usize {
        self.inside().count()
    }

    /// Whether a shape has all pixels that are inside, and none that are outside.
    fn is_shape(&self, contains: impl Fn(u32, u32) -> bool) -> bool {
        self.pixels().all(|(i, j, place)| match place {
            Place::Inside => contains(i, j),
            Place::Either => true,
            Place::Outside => !contains(i, j),
        })
    }

    /// The first shape of those we know that fits; None where it is the whole picture.
    fn find_shape(&self) -> Option<Shape> {
        if !self.places.contains(&Place::Outside) {
            return None;
        }
        let shapes = [
            Self::find_border,
            Self::find_crossings,
            Self::find_rest,
            Self::find_rectangles,
            Self::find_stride,
            Self::find_diagonals,
        ];
        shapes.iter().find_map(|find| find(self))
    }

    /// Bars on both sides, or above and below, or a frame.
    fn find_border(&self) -> Option<Shape> {
        let kept = self.pixels().filter(|(_, _, place)| *place == Place::Outside);
        let kept: Vec<_> = kept.collect();
        let first_column = kept.iter().map(|(i, _, _)| *i).min()?;
        let last_column = kept.iter().map(|(i, _, _)| *i).max()?;
        let (first_row, last_row) = (kept.first()?.1, kept.last()?.1);
        let is_border = |i: u32, j: u32| {
            !((first_column..=last_column).contains(&i) && (first_row..=last_row).contains(&j))
        };
        let sides = [
            ("on the left", first_column),
            ("on the right", self.columns - 1 - last_column),
            ("above", first_row),
            ("below", self.rows - 1 - last_row),
        ];
        let bars: Vec<_> = sides.into_iter().filter(|(_, width)| 0 < *width).collect();
        // A bar on one side alone is a rectangle, and may be a loop that ends too soon; and a border
        // is around something.
        if bars.len() < 2 || kept.len() < LEAST_PIXELS || !self.is_shape(is_border) {
            return None;
        }
        let shape = if bars.len() == 4 { "a frame" } else { "bars" };
        let widths = bars.iter().map(|(side, width)| format!("{width} {side}"));
        let widths = widths.collect::<Vec<_>>().join(", ");
        // Loops may leave out the first and the last, but more is put around a finished picture.
        let drawn_by_program = bars.iter().all(|(_, width)| *width == 1);
        let simile = if drawn_by_program { "" } else { ", as editors add them" };
        let words = format!("{shape}{simile}, in pixels: {widths}");
        Some(Shape { words, drawn_by_program })
    }

    /// All crossings of some columns and rows.
    fn find_crossings(&self) -> Option<Shape> {
        let columns: BTreeSet<_> = self.inside().map(|(i, _)| i).collect();
        let rows: BTreeSet<_> = self.inside().map(|(_, j)| j).collect();
        let is_crossing = |i: u32, j: u32| columns.contains(&i) && rows.contains(&j);
        let is_shape = self.is_shape(is_crossing);
        let words = join(&self.format_lines("column", &columns), &self.format_lines("row", &rows));
        is_shape.then_some(Shape { words: words?, drawn_by_program: true })
    }

    /// All but the crossings of some columns and rows, such as lines between tiles.
    fn find_rest(&self) -> Option<Shape> {
        let columns: BTreeSet<_> = (0..self.columns).collect();
        let rows: BTreeSet<_> = (0..self.rows).collect();
        let outside = || self.pixels().filter(|(_, _, place)| *place == Place::Outside);
        let kept_columns: BTreeSet<_> = outside().map(|(i, _, _)| i).collect();
        let kept_rows: BTreeSet<_> = outside().map(|(_, j, _)| j).collect();
        let is_shape = self.is_shape(|i, j| !kept_columns.contains(&i) || !kept_rows.contains(&j));
        let columns = &columns - &kept_columns;
        let rows = &rows - &kept_rows;
        if !is_shape || columns.is_empty() || rows.is_empty() {
            return None;
        }
        let words = [self.format_lines("column", &columns), self.format_lines("row", &rows)];
        let words = words.into_iter().flatten().collect::<Vec<_>>().join(" and ");
        Some(Shape { words, drawn_by_program: true })
    }

    /// A few rectangles, such as the tiles of processors that drew nothing.
    fn find_rectangles(&self) -> Option<Shape> {
        let mut rest = self.places.clone();
        let index = |i: u32, j: u32| (j * self.columns + i) as usize;
        let mut words = vec![];
        while let Some(first) = rest.iter().position(|place| *place == Place::Inside) {
            if words.len() == MOST_RECTANGLES {
                return None;
            }
            let (left, top) = (first as u32 % self.columns, first as u32 / self.columns);
            let is_inside = |i, j| rest[index(i, j)] == Place::Inside;
            let right = (left..self.columns).take_while(|i| is_inside(*i, top)).last()?;
            let is_row = |j: &u32| (left..=right).all(|i| is_inside(i, *j));
            let bottom = (top..self.rows).take_while(is_row).last()?;
            for j in top..=bottom {
                rest[index(left, j)..=index(right, j)].fill(Place::Either);
            }
            let [columns, rows] = [left..=right, top..=bottom].map(BTreeSet::from_iter);
            words.push(join(
                &self.format_lines("column", &columns),
                &self.format_lines("row", &rows),
            )?);
        }
        Some(Shape { words: words.join(", and "), drawn_by_program: true })
    }

    /// Every so many pixels, counted row by row.
    fn find_stride(&self) -> Option<Shape> {
        let number = |i: u32, j: u32| j * self.columns + i;
        let (period, rests) = self.find_period(number)?;
        let pixels = format_rests("pixel", period, &rests);
        let words = format!("{pixels}, counted row by row");
        Some(Shape { words, drawn_by_program: true })
    }

    fn find_diagonals(&self) -> Option<Shape> {
        let describe = |direction: &str, (period, rests): (u32, BTreeSet<u32>)| {
            let words = format!("{}, {direction}", format_rests("diagonal", period, &rests));
            Shape { words, drawn_by_program: true }
        };
        // The rows are added, so that the difference isn't below 0.
        let falling = self.find_period(|i, j| i + self.rows - j);
        let falling = falling.map(|found| describe("falling to the right", found));
        falling.or_else(|| Some(describe("rising to the right", self.find_period(|i, j| i + j)?)))
    }

    /// The smallest period of a number of each pixel whose rests tell the shape, and these rests.
    fn find_period(&self, number: impl Fn(u32, u32) -> u32) -> Option<(u32, BTreeSet<u32>)> {
        let inside: Vec<_> = self.inside().map(|(i, j)| number(i, j)).collect();
        (2..=LARGEST_PERIOD).find_map(|period| {
            let rests: BTreeSet<_> = inside.iter().map(|number| number % period).collect();
            let is_shape = self.is_shape(|i, j| rests.contains(&(number(i, j) % period)));
            is_shape.then_some((period, rests))
        })
    }

    /// Such as `row 3`, `rows 3 to 9`, `every 2nd row from 1 to 359`; None of all lines.
    fn format_lines(&self, word: &str, lines: &BTreeSet<u32>) -> Option<String> {
        let all = if word == "row" { self.rows } else { self.columns };
        let (first, last) = (lines.first()?, lines.last()?);
        let mut steps = lines.iter().zip(lines.iter().skip(1)).map(|(line, next)| next - line);
        let step = steps.next().unwrap_or(1);
        Some(match (lines.len(), steps.all(|other| other == step)) {
            (count, _) if count == all as usize => return None,
            (1, _) => format!("{word} {first}"),
            (_, true) if step == 1 => format!("{word}s {first} to {last}"),
            (_, true) => format!("every {} {word} from {first} to {last}", format_ordinal(step)),
            (count, false) => format!("{count} {word}s between {first} and {last}"),
        })
    }
}

/// Columns of rows; None where both are all.
fn join(columns: &Option<String>, rows: &Option<String>) -> Option<String> {
    let both = [columns, rows].into_iter().flatten().map(String::as_str);
    let both: Vec<_> = both.collect();
    (!both.is_empty()).then(|| both.join(" of "))
}

fn format_rests(word: &str, period: u32, rests: &BTreeSet<u32>) -> String {
    match rests.len() {
        1 => format!("every {} {word}", format_ordinal(period)),
        count => format!("{count} of every {period} {word}s"),
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
