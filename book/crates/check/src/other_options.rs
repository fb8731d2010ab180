//! Finds the options (`--width`, `--aspect`, `--fov`, `--samples`) with which a right program draws
//! the reader's picture.

use crate::comparison::{Budget, scattered_positions};
use crate::step_scene::StepScene;
use crate::transformed::uniform_colour;
use course::{FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS};
use image::RgbImage;
use std::iter;
use step01_rays::{Camera, mean_colour, rgb8, sub_pixel_offsets};

/// The columns and rows of a picture that is drawn with the default options.
const DEFAULT_SIZE: (u32, u32) = (PICTURE_COLUMNS, PICTURE_ROWS);

/// The maximum number of rays for comparing a picture with one choice of options. All choices
/// together may take twice this number.
const MAX_RAYS: u32 = 1 << 23;

/// The maximum number of rays for ruling out choices of options.
const PROBE_RAYS: u32 = 6_000_000;

/// The number of pixels that are compared first, since they rule out most choices of options.
const PROBE_PIXELS: usize = 200;

/// The allowance for rounding errors in a byte of the sky.
const ROUNDING: f64 = 1e-6;

/// If a pixel shows a single object, the pixel's mean colour differs from the colour at the pixel's
/// centre by less than this, in units of a byte.
const OBJECT_TOLERANCE: f64 = 64.0;

/// In pictures with fewer columns than this, `OBJECT_TOLERANCE` doesn't hold, because a pixel may
/// cover a large part of an object.
const COARSE_COLUMNS: u32 = 64;

/// A border pixel counts as sky if it is as blue as the sky. A few of these pixels may nevertheless
/// belong to an object, so we allow for one wrong byte in this many bytes.
const BORDER_BYTES_PER_WRONG_BYTE: i32 = 20;

/// Angles with four decimals are tried only if the bounds on the angle are less than this many
/// degrees apart.
const MAX_DEGREES_FOR_FOUR_DECIMALS: f64 = 1.0;

/// Options with which a right program draws the reader's picture.
pub(crate) struct Options {
    size: (u32, u32),
    fov_degrees: f64,
    samples: u32,
    /// The number of pixels that were compared: all pixels, unless comparing all would take too
    /// many rays.
    compared_count: usize,
    /// Whether the picture is one colour. Many choices of options produce such a picture.
    is_one_colour: bool,
}

impl Options {
    /// Whether the angle has at most one decimal. Hardly anybody types more decimals.
    pub fn has_at_most_one_decimal(&self) -> bool {
        let tenths = 10.0 * self.fov_degrees;
        tenths == tenths.round()
    }

    /// The sentence after the list of causes. It says that a right program with these options draws
    /// the reader's picture, too, or may draw it if not all pixels were compared.
    pub fn same_picture_sentence(&self) -> String {
        let (columns, rows) = self.size;
        let mut options = format!("--fov {}", self.fov_degrees);
        if self.size != DEFAULT_SIZE {
            options += &format!(" --width {columns} --aspect {columns}:{rows}");
        }
        if self.samples != 1 {
            options += &format!(" --samples {}", self.samples);
        }
        let pixel_count = columns as usize * rows as usize;
        match self.compared_count {
            count if count < pixel_count => format!(
                "So may the right program with {options}: {count} of {pixel_count} pixels were \
                 compared."
            ),
            _ => format!("So does the right program with {options}."),
        }
    }

    /// Whether the picture is one colour. Many options produce such a picture.
    pub fn is_one_colour(&self) -> bool {
        self.is_one_colour
    }

    /// A sentence that says that the reader's picture was drawn with these options. `title` names
    /// our picture, as in `the picture of glass`.
    pub fn headline(&self, title: &str) -> String {
        let ((columns, rows), samples) = (self.size, self.samples);
        let pixel_count = columns as usize * rows as usize;
        let options = format!(
            "{title} at {columns}×{rows} pixels, {}° and {samples}×{samples} rays per pixel",
            self.fov_degrees
        );
        match self.compared_count {
            _ if self.is_one_colour => format!(
                "This is {options}, in every pixel, but one colour says little: further options \
                 and mistakes may give it, too."
            ),
            count if count < pixel_count => {
                format!(
                    "{count} of {pixel_count} pixels were compared, and are those of {options}."
                )
            }
            _ => format!("This is what a right program draws, in every pixel: {options}."),
        }
    }

    /// The lines after the headline. These lines say which options our picture is drawn with, and
    /// where to look if the reader gave no other options.
    pub fn advice_on_default_options() -> Vec<String> {
        vec![
            "Ours is drawn with the default options: --width 640 --aspect 16:9 --fov 60 --samples 1."
                .to_owned(),
            "If you gave no other options, look at how your program reads them, and at its camera."
                .to_owned(),
        ]
    }
}

/// Finds the simplest options with which a right program draws this picture from a scene. Returns
/// None if there are no such options, or if the search takes too many rays.
pub(crate) fn find_options(scene: &StepScene, yours: &RgbImage) -> Option<Options> {
    let size @ (columns, rows) = yours.dimensions();
    if columns < 2 {
        return None;
    }
    let all_offsets: Vec<_> = (1..=16).map(sub_pixel_offsets).collect();
    let (probe_budget, budget) = (Budget::new(PROBE_RAYS), Budget::new(2 * MAX_RAYS));
    let mut border_probes: Vec<_> = sampled_border_positions(size).take(PROBE_PIXELS).collect();
    let mut probes: Vec<_> = scattered_positions(size).take(PROBE_PIXELS).collect();
    for fov_degrees in angles_with_at_most_one_decimal().chain(fine_angles_that_fit_border(yours)) {
        let camera = Camera::new(columns, rows, fov_degrees.to_radians());
        let may_be_right = |position: &_| may_be_right(scene, &camera, yours, *position);
        if !probe_budget.holds_for_all(&mut border_probes, 1, may_be_right) {
            continue;
        }
        for (samples, offsets) in (1..).zip(&all_offsets) {
            let rays = samples * samples;
            let is_equal = |&(i, j): &(u32, u32)| {
                let (x, y) = (f64::from(i), f64::from(j));
                let ours = mean_colour(offsets, |u, v| scene.colour(&camera.ray(x + u, y + v)));
                *yours.get_pixel(i, j) == rgb8(ours)
            };
            if !probe_budget.holds_for_all(&mut probes, rays, is_equal) {
                continue;
            }
            let compared_count = yours.pixels().len().min((MAX_RAYS / rays) as usize);
            let mut positions = scattered_positions(size).take(compared_count);
            if positions.all(|position| budget.spend(rays) && is_equal(&position)) {
                let is_one_colour = uniform_colour(yours).is_some();
                return Some(Options { size, fov_degrees, samples, compared_count, is_one_colour });
            }
        }
    }
    None
}

/// Returns angles in degrees: the default, then whole numbers, then numbers with one decimal.
fn angles_with_at_most_one_decimal() -> impl Iterator<Item = f64> {
    let tenths = (1..1800).filter(|number| number % 10 != 0).map(|number| f64::from(number) / 10.0);
    iter::once(FOV_DEGREES).chain((1..180).map(f64::from)).chain(tenths)
}

/// Returns angles with two decimals, then angles with three. The angles fit the sky in the border
/// pixels of the picture's upper half. If only a narrow range of angles fits, angles with four
/// decimals follow.
fn fine_angles_that_fit_border(yours: &RgbImage) -> impl Iterator<Item = f64> {
    let (columns, rows) = yours.dimensions();
    let side = f64::from(columns - 1);
    let mut intervals = vec![];
    let upper_sides = (0..rows / 2).flat_map(|j| [(0, j), (columns - 1, j)]);
    for (i, j) in (0..columns).map(|i| (i, 0)).chain(upper_sides) {
        let colour = yours.get_pixel(i, j);
        // In the sky, V is (x tan(θ/2), y tan(θ/2), −1), and the colour is 0.7 + 0.3 (Vx, Vy, −Vz).
        // So blue is 255. The closure `tan` computes tan(θ/2) from a red or green byte.
        let x = 2.0 * f64::from(i) / side - 1.0;
        let y = (f64::from(rows - 1) - 2.0 * f64::from(j)) / side;
        for (factor, byte) in [(x, colour[0]), (y, colour[1])] {
            if factor == 0.0 || colour[2] != 255 || byte == 0 || byte == 255 {
                continue;
            }
            let tan = |offset: f64| ((f64::from(byte) + offset) / 255.0 - 0.7) / 0.3 / factor;
            let (a, b) = (tan(-0.5 - ROUNDING), tan(0.5 + ROUNDING));
            if a.max(b) >= 0.0 {
                intervals.push((a.min(b).max(0.0), a.max(b)));
            }
        }
    }
    let (min_tan, max_tan) = find_almost_common_bounds(&intervals);
    let [min, max] = [min_tan, max_tan].map(|tan| 2.0 * tan.atan().to_degrees());
    let is_narrow = max - min < MAX_DEGREES_FOR_FOUR_DECIMALS;
    let scales = if is_narrow { &[1e2, 1e3, 1e4][..] } else { &[1e2, 1e3] };
    scales.iter().flat_map(move |scale| {
        let numbers = (min * scale).ceil() as u32..=(max * scale).floor() as u32;
        let is_finer = |number: &u32| !number.is_multiple_of(10);
        numbers.filter(is_finer).map(move |number| f64::from(number) / scale)
    })
}

/// Returns the smallest and the largest number that lie in enough intervals: in as many as any
/// number, or in a few fewer, at most one in `BORDER_BYTES_PER_WRONG_BYTE`. A few intervals may be
/// wrong, because a highlight may pass for sky. If there are no intervals, returns 0 and infinity.
fn find_almost_common_bounds(intervals: &[(f64, f64)]) -> (f64, f64) {
    if intervals.is_empty() {
        return (0.0, f64::INFINITY);
    }
    let starts = intervals.iter().map(|(start, _)| (*start, 1));
    let ends = intervals.iter().map(|(_, end)| (*end, -1));
    let mut changes: Vec<(f64, i32)> = starts.chain(ends).collect();
    // Sort starts before ends: if an interval ends where another starts, their common number lies
    // in both.
    changes.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    let counts: Vec<_> = changes
        .iter()
        .scan(0, |count, (_, change)| {
            *count += change;
            Some(*count)
        })
        .collect();
    let max_count = counts.iter().copied().max().unwrap_or(0);
    let is_enough = |count: &i32| *count >= max_count - max_count / BORDER_BYTES_PER_WRONG_BYTE;
    // `counts[k]` is the count between `changes[k]` and `changes[k + 1]`. So the last count that is
    // large enough holds until the change after it.
    let first_index = counts.iter().position(is_enough).unwrap_or(0);
    let last_index = counts.iter().rposition(is_enough).map_or(0, |k| k + 1);
    (changes[first_index].0, changes[last_index].0)
}

/// Returns at most 50 positions on each side of a picture, starting at a corner. With most angles
/// of view, these positions show the sky, where `may_be_right` is strictest.
fn sampled_border_positions((columns, rows): (u32, u32)) -> impl Iterator<Item = (u32, u32)> {
    let downwards = (0..rows).step_by(rows.div_ceil(50) as usize);
    let across = (0..columns).step_by(columns.div_ceil(50) as usize);
    let sides = downwards.flat_map(move |j| [(0, j), (columns - 1, j)]);
    sides.chain(across.flat_map(move |i| [(i, 0), (i, rows - 1)]))
}

/// Whether a right program may have drawn this pixel, whatever its number of samples. A program
/// with many samples draws the mean colour of the pixel, but we compute only the colour at the
/// pixel's centre. In the sky, colours change linearly, so the mean and the colour at the centre
/// are equal. Within an object, they are close if pixels are small. If a pixel on an object is
/// large, or if the pixel shows an edge, the mean may be anything, so we accept every colour.
fn may_be_right(scene: &StepScene, camera: &Camera, yours: &RgbImage, (i, j): (u32, u32)) -> bool {
    let (x, y) = (f64::from(i), f64::from(j));
    let object_at = |(u, v)| scene.visible_hit(&camera.ray(x + u, y + v)).map(|hit| hit.object);
    let (intensity, centre_object) = (scene.colour(&camera.ray(x, y)), object_at((0.0, 0.0)));
    let tolerance = match centre_object {
        None => 0.5 + ROUNDING,
        Some(_) => OBJECT_TOLERANCE,
    };
    let is_near = |k: usize| {
        let exact_byte = (255.0 * intensity[k]).clamp(0.0, 255.0);
        (exact_byte - f64::from(yours.get_pixel(i, j)[k])).abs() < tolerance
    };
    let corners = [(-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5)];
    let has_edge = || corners.into_iter().any(|corner| object_at(corner) != centre_object);
    let is_coarse = centre_object.is_some() && camera.h_res < COARSE_COLUMNS;
    (0..3).all(is_near) || is_coarse || has_edge()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn almost_common_bounds_lie_in_almost_all_intervals() {
        assert_eq!(find_almost_common_bounds(&[]), (0.0, f64::INFINITY));
        assert_eq!(find_almost_common_bounds(&[(1.0, 3.0), (2.0, 4.0)]), (2.0, 3.0));
        assert_eq!(find_almost_common_bounds(&[(1.0, 2.0), (2.0, 4.0)]), (2.0, 2.0));
        // One interval in twenty-one may lie outside of the bounds.
        let mut intervals = vec![(1.0, 2.0); 20];
        intervals.push((5.0, 6.0));
        assert_eq!(find_almost_common_bounds(&intervals), (1.0, 2.0));
    }

    #[test]
    fn angles_begin_with_the_default_and_end_with_tenths() {
        let angles: Vec<_> = angles_with_at_most_one_decimal().collect();
        assert_eq!((angles[0], angles[1]), (60.0, 1.0));
        assert_eq!(angles.len(), 1 + 179 + 1799 - 179);
        assert_eq!(angles.last(), Some(&179.9));
    }

    #[test]
    fn border_is_sampled_on_all_sides() {
        let positions: Vec<_> = sampled_border_positions((64, 36)).collect();
        assert!(positions.iter().all(|(i, j)| [0, 63].contains(i) || [0, 35].contains(j)));
        for corner in [(0, 0), (63, 0), (0, 35)] {
            assert!(positions.contains(&corner), "{corner:?}");
        }
        assert!(sampled_border_positions((5000, 5000)).count() <= 200);
    }

    #[test]
    fn options_are_named_as_they_are_typed() {
        let options = |size, samples, compared_count| Options {
            size,
            fov_degrees: 75.5,
            samples,
            compared_count,
            is_one_colour: false,
        };
        let fully_compared_options = options((640, 360), 1, 230_400);
        assert_eq!(
            fully_compared_options.same_picture_sentence(),
            "So does the right program with --fov 75.5."
        );
        let partly_compared_options = options((64, 32), 2, 100);
        let sentence = "So may the right program with --fov 75.5 --width 64 --aspect 64:32 \
                        --samples 2: 100 of 2048 pixels were compared.";
        assert_eq!(partly_compared_options.same_picture_sentence(), sentence);
        assert!(fully_compared_options.has_at_most_one_decimal());
        assert!(
            !Options { fov_degrees: 75.55, ..fully_compared_options }.has_at_most_one_decimal()
        );
    }
}
