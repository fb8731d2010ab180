//! Finds cameras that differ from ours and reproduce the reader's picture.
//!
//! We first try cameras with wrong formulas that somebody may have written. If none of these
//! cameras fits, we change a single number in D_u, D_v or V_0. The sky tells us which values this
//! number may have. A ray that hits nothing has the red 0.7 + 0.3 V_x and the green 0.7 + 0.3 V_y,
//! where V = D_u i + D_v j + V_0. So each byte of the sky confines the number to an interval.

use crate::comparison::{Budget, Comparison, Pixel};
use crate::number_format::replace_hyphens_with_minus;
use crate::step_scene::StepScene;
use course::{PICTURE_ROWS, Step, camera};
use std::ops::RangeInclusive;
use step01_rays::Camera;

/// One of six numbers in the camera's matrix: the x or the y of the vector D_u, D_v or V_0.
#[derive(Clone, Copy)]
struct MatrixEntry {
    column: usize,
    row: usize,
}

/// Describes the cameras that reproduce the reader's picture exactly.
pub(crate) fn describe_fitting_cameras(
    comparison: &Comparison,
    scene: &StepScene,
    budget: &Budget,
) -> Vec<String> {
    let mut pixels: Vec<_> = comparison.pixels().collect();
    let mut gives_picture = |camera: &Camera| {
        let ray = |pixel: &Pixel| camera.ray(pixel.position.0.into(), pixel.position.1.into());
        budget.holds_for_all(&mut pixels, 1, |pixel| scene.bytes(&ray(pixel)) == pixel.yours)
    };
    let mut descriptions: Vec<_> = cameras_with_wrong_formulas()
        .into_iter()
        .filter(|(camera, _)| gives_picture(camera))
        .map(|(_, description)| description)
        .collect();
    if descriptions.is_empty() {
        descriptions.extend(MatrixEntry::all_x_and_y().filter_map(|number| {
            let mut values = candidate_values_from_sky(comparison, scene, number).into_iter();
            let value = values.find(|value| gives_picture(&number.camera_with(*value)))?;
            Some(number.describe(&value.to_string()))
        }));
    }
    // In step 1, wrong colours of the directions may look the same as a wrong camera.
    if scene.step == Step::Rays && !descriptions.is_empty() {
        descriptions.push("other colours of the directions".into());
    }
    descriptions
}

impl MatrixEntry {
    /// All six numbers.
    fn all_x_and_y() -> impl Iterator<Item = Self> {
        (0..2).flat_map(|row| (0..3).map(move |column| Self { column, row }))
    }

    fn our_value(self) -> f64 {
        camera().matrix.col(self.column)[self.row]
    }

    /// Returns our camera with this number set to `value`.
    fn camera_with(self, value: f64) -> Camera {
        let mut camera = camera();
        camera.matrix.col_mut(self.column)[self.row] = value;
        camera
    }

    /// Describes a change of this number to `value`, such as `x of D_u = 0.002 instead of
    /// 0.001807`.
    fn describe(self, value: &str) -> String {
        let axis = ["x", "y"][self.row];
        let vector = ["D_u", "D_v", "V_0"][self.column];
        replace_hyphens_with_minus(&format!(
            "{axis} of {vector} = {value} instead of {:.6}",
            self.our_value()
        ))
    }
}

/// Returns cameras that each have a plausible mistake in one formula: the formula for one number in
/// the camera's matrix, or the formula for the height of the view. Each camera comes with a
/// description of the wrong formula.
fn cameras_with_wrong_formulas() -> Vec<(Camera, String)> {
    let ours = camera();
    let tan = -ours.matrix.z_axis.x;
    let (h_res, v_res) = (f64::from(ours.h_res), f64::from(ours.v_res));
    let mut cameras = vec![];
    let divisors = [
        ("hRes", h_res),
        ("(hRes − 2)", h_res - 2.0),
        ("(hRes + 1)", h_res + 1.0),
        ("vRes", v_res),
        ("(vRes − 1)", v_res - 1.0),
    ];
    for (name, divisor) in divisors {
        for (number, sign, minus) in [
            (MatrixEntry { column: 0, row: 0 }, 1.0, ""),
            (MatrixEntry { column: 1, row: 1 }, -1.0, "−"),
        ] {
            let words = number.describe(&format!("{minus}2 tan(θ/2)/{name}"));
            cameras.push((number.camera_with(sign * 2.0 * tan / divisor), words));
        }
    }
    let ratios = [
        ("9/16", 9.0 / 16.0),
        ("1/1.7", 1.0 / 1.7),
        ("1/1.77", 1.0 / 1.77),
        ("1/1.777", 1.0 / 1.777),
        ("1/1.778", 1.0 / 1.778),
        ("1/1.78", 1.0 / 1.78),
        ("0.56", 0.56),
        ("0.562", 0.562),
        ("vRes/(hRes − 1)", v_res / (h_res - 1.0)),
        ("(vRes − 1)/hRes", (v_res - 1.0) / h_res),
    ];
    for (name, ratio) in ratios {
        let half_height = ratio * tan;
        let number = MatrixEntry { column: 2, row: 1 };
        let mut camera = number.camera_with(half_height);
        cameras.push((camera, number.describe(&format!("{name} · tan(θ/2)"))));
        camera.matrix.y_axis.y = -2.0 * half_height / (v_res - 1.0);
        let words = format!("the view is {name} times as high as wide, in V_0 and in D_v");
        cameras.push((camera, words));
    }
    cameras
}

/// Returns candidates for the value of a number. Candidates with few digits come first. All
/// candidates reproduce the sky, but the caller still has to test them on the whole picture. If our
/// own value also reproduces the sky, returns no candidates, since then the number isn't the cause.
fn candidate_values_from_sky(
    comparison: &Comparison,
    scene: &StepScene,
    number: MatrixEntry,
) -> Vec<f64> {
    let Some(bounds) = bound_by_sky(comparison, scene, number) else { return vec![] };
    let (ours, matrix) = (number.our_value(), camera().matrix);
    if bounds.contains(&ours) {
        return vec![];
    }
    // A candidate is a start plus a round multiple of a unit. The three pairs of start and unit
    // give these candidates:
    //
    // - a round number
    // - a round multiple of our number
    // - for V_0, our number plus a round multiple of the distance between neighbouring pixels,
    //   which is the x of D_u or the y of D_v
    //
    // For D_u and D_v, the third pair gives a round multiple of our number again.
    let pixel_steps = [matrix.x_axis.x, matrix.y_axis.y];
    let pixel_step = if number.column == 2 { pixel_steps[number.row] } else { ours };
    let starts_and_units = [(0.0, 1.0), (0.0, ours), (ours, pixel_step)];
    let middle = (bounds.start() + bounds.end()) / 2.0;
    let round_values = (0..8).flat_map(|digits| {
        let scale = 10_f64.powi(digits);
        starts_and_units
            .map(|(start, unit)| start + ((middle - start) / unit * scale).round() / scale * unit)
    });
    let candidates = round_values.chain([middle]).filter(|value| bounds.contains(value));
    // The answer prints all digits of a candidate. Round the candidates to 12 decimals to remove
    // the digits that come from floating-point errors.
    candidates.map(|value| (value * 1e12).round() / 1e12).collect()
}

/// Returns the interval of all values of a matrix number that reproduce your sky in one channel: in
/// red if the number is an x, in green if it is a y. Returns None if there is no such value.
fn bound_by_sky(
    comparison: &Comparison,
    scene: &StepScene,
    MatrixEntry { column, row }: MatrixEntry,
) -> Option<RangeInclusive<f64>> {
    let matrix = camera().matrix;
    let (mut start, mut end) = (f64::NEG_INFINITY, f64::INFINITY);
    // A pixel counts as sky on three conditions:
    //
    // - Our picture shows the sky at this pixel.
    // - Your blue byte is 255.
    // - Of red and green, only one channel depends on the number. In the other channel, your byte
    //   equals ours.
    //
    // From step 4 on, a bright surface might pass for sky, so we look only at the upper third of
    // the picture, where there are hardly any highlights.
    let rows = if scene.step < Step::Diffuse { 0..PICTURE_ROWS } else { 0..PICTURE_ROWS / 3 };
    let is_sky = |pixel: &&Pixel| {
        let Pixel { yours, ours, hit, .. } = pixel;
        hit.is_none() && yours[2] == 255 && yours[1 - row] == ours[1 - row]
    };
    for pixel in comparison.pixels().filter(|pixel| rows.contains(&pixel.position.1)).filter(is_sky)
    {
        let byte = f64::from(pixel.yours[row]);
        if !(1.0..255.0).contains(&byte) {
            continue;
        }
        let factor = f64::from([pixel.position.0, pixel.position.1, 1][column]);
        let other_terms = pixel.ray.direction[row] - factor * matrix.col(column)[row];
        let bound = |byte: f64| (byte / 255.0 - 0.7) / 0.3 - other_terms;
        let [low, high] = [bound(byte - 0.5), bound(byte + 0.5)];
        if factor > 0.0 {
            (start, end) = (start.max(low / factor), end.min(high / factor));
        }
        if end < start || factor == 0.0 && !(low..=high).contains(&0.0) {
            return None;
        }
    }
    Some(start..=end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::target::Target;
    use image::RgbImage;
    use step01_rays::{picture, render};

    const D_U: MatrixEntry = MatrixEntry { column: 0, row: 0 };
    const D_V: MatrixEntry = MatrixEntry { column: 1, row: 1 };
    const V_0: MatrixEntry = MatrixEntry { column: 2, row: 1 };

    fn step01_target() -> Target {
        Target::of_locked("step01_rays", picture(&camera(), 1))
    }

    fn bounds(yours: &RgbImage, number: MatrixEntry) -> Option<RangeInclusive<f64>> {
        let target = step01_target();
        let scene = target.scene.as_ref().expect("a step has a scene");
        let comparison = Comparison::new(&target, yours).expect("the pictures differ");
        bound_by_sky(&comparison, scene, number)
    }

    #[test]
    fn number_in_each_matrix_column_is_found_from_the_sky() {
        let target = step01_target();
        let scene = target.scene.as_ref().expect("a step has a scene");
        for (number, value, words) in [
            (D_U, 0.0017, "x of D_u = 0.0017 instead of 0.001807"),
            (D_V, -0.002, "y of D_v = −0.002 instead of −0.001807"),
            (V_0, 0.3, "y of V_0 = 0.3 instead of 0.324364"),
        ] {
            let yours = picture(&number.camera_with(value), 1);
            let comparison = Comparison::new(&target, &yours).expect("the pictures differ");
            let cameras = describe_fitting_cameras(&comparison, scene, &Budget::new(10_000_000));
            assert_eq!(cameras, [words, "other colours of the directions"]);
        }
    }

    #[test]
    fn no_value_fits_a_wrong_byte_that_does_not_depend_on_the_number() {
        let mut yours = picture(&D_U.camera_with(0.0017), 1);
        let range = bounds(&yours, D_U).expect("some values reproduce the sky");
        assert!(range.contains(&0.0017) && !range.contains(&D_U.our_value()), "{range:?}");
        // In column 0, V doesn't depend on D_u.
        yours[(0, 5)][0] += 1;
        assert_eq!(bounds(&yours, D_U), None);
    }

    #[test]
    fn no_value_fits_bytes_that_contradict_each_other() {
        let mut yours = picture(&D_U.camera_with(0.0017), 1);
        yours[(639, 5)][0] += 1;
        assert_eq!(bounds(&yours, D_U), None);
    }

    #[test]
    fn clamped_bytes_and_other_channels_bound_nothing() {
        let ours = picture(&camera(), 1);
        // Every red byte is clamped, so any value of D_u would do.
        let white = RgbImage::from_fn(640, 360, |i, j| [255, ours[(i, j)][1], 255].into());
        assert_eq!(bounds(&white, D_U), Some(f64::NEG_INFINITY..=f64::INFINITY));
        // All three channels are halved, so no pixel counts as sky.
        let half_as_bright = render(&camera(), 1, |ray| step01_rays::direction_colour(ray) * 0.5);
        assert_eq!(bounds(&half_as_bright, D_U), Some(f64::NEG_INFINITY..=f64::INFINITY));
    }

    /// Changes one number of our camera, draws the picture of step 3, and runs
    /// `describe_fitting_cameras` on this picture.
    fn describe_cameras_that_fit_the_picture_with(number: MatrixEntry, value: f64) -> Vec<String> {
        let target = Target::of_locked("step03_nearest", step03_nearest::picture(&camera(), 1));
        let scene = target.scene.as_ref().expect("a step has a scene");
        let yours = step03_nearest::picture(&number.camera_with(value), 1);
        let comparison = Comparison::new(&target, &yours).expect("the pictures differ");
        describe_fitting_cameras(&comparison, scene, &Budget::new(10_000_000))
    }

    #[test]
    fn multiples_of_our_number_and_shifts_by_whole_pixels_are_tried() {
        let twice = 2.0 * D_U.our_value();
        let words = format!("x of D_u = {:.12} instead of 0.001807", twice);
        assert_eq!(describe_cameras_that_fit_the_picture_with(D_U, twice), [words]);
        let three_rows_lower = V_0.our_value() + 3.0 * D_V.our_value();
        let words = format!("y of V_0 = {:.12} instead of 0.324364", three_rows_lower);
        assert_eq!(describe_cameras_that_fit_the_picture_with(V_0, three_rows_lower), [words]);
    }

    #[test]
    fn each_wrong_formula_changes_the_matrix_as_described() {
        let ours = camera().matrix;
        let lines = cameras_with_wrong_formulas().into_iter().map(|(camera, words)| {
            let numbers = MatrixEntry::all_x_and_y().filter_map(|number| {
                let value = camera.matrix.col(number.column)[number.row];
                (value != number.our_value()).then(|| format!("{value:.9}"))
            });
            assert_ne!(camera.matrix, ours, "{words}");
            format!("{words}: {}", numbers.collect::<Vec<_>>().join(", "))
        });
        insta::assert_snapshot!(lines.collect::<Vec<_>>().join("\n"));
    }
}
