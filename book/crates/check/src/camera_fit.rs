//! The camera that a sky tells: where nothing is hit, red is 0.7 + 0.3 V_x and green 0.7 +
//! 0.3 V_y, so that each is a plane over the picture, a·i + b·j + c.

use crate::comparison::{Comparison, Pixel};
use course::Step;
use glam::{DMat3, DVec3};
use step01_rays::Camera;

/// How far off a channel of 0 to 1 may be while its plane is fitted again; the last are little
/// more than what the rounding of a byte does.
const LIMITS: [f64; 6] = [f64::INFINITY, 0.05, 0.01, 0.005, 0.003, 0.0025];

/// The least bytes by which another number of the camera has to change the sky somewhere.
const LEAST_CHANGE: f64 = 0.1;

/// The camera that the sky of yours tells, where it isn't ours, and all that it may be, in
/// words. The z of its vectors leave no trace in the sky and are ours; whether it gives the
/// picture is still to be tried.
pub(crate) fn fitted_camera(comparison: &Comparison) -> Option<(Vec<String>, Camera)> {
    let ours = comparison.camera;
    let mut rows = [fit_row(comparison, 0)?, fit_row(comparison, 1)?, ours.matrix.row(2)];
    let mut clauses = vec![];
    for (k, name) in ["D_u", "D_v", "V_0"].into_iter().enumerate() {
        let count = f64::from([ours.h_res, ours.v_res, 1][k]);
        let right = [0, 1].map(|row| ours.matrix.row(row)[k]);
        for row in [0, 1] {
            let pixel = if k == 2 { ours.matrix.row(row)[row] } else { 0.0 };
            rows[row][k] = plain_number(rows[row][k], right[row], pixel, count);
        }
        let yours = [rows[0][k], rows[1][k]];
        if yours != right {
            let [[a, b], [c, d]] = [yours, right].map(|pair| pair.map(format_decimals));
            clauses.push(format!("({a}, {b}) instead of ({c}, {d}) as x and y of {name}"));
        }
    }
    if clauses.is_empty() {
        return None;
    }
    let [x, y, z] = rows;
    let camera = Camera { matrix: DMat3::from_cols(x, y, z).transpose(), ..ours };
    let mut words = vec![format!("with {}", clauses.join(", "))];
    if (camera.matrix.x_axis, camera.matrix.y_axis) == (ours.matrix.x_axis, ours.matrix.y_axis) {
        let shift = camera.matrix.z_axis - ours.matrix.z_axis;
        let (u, v) = (shift.x / ours.matrix.x_axis.x, shift.y / ours.matrix.y_axis.y);
        let [u, v] = [u, v].map(|one| format_decimals((100.0 * one).round() / 100.0));
        words.push(format!("with rays {u} columns to the right and {v} rows below"));
    }
    if comparison.drawing.is_some_and(|drawing| drawing.step == Step::Rays) {
        words.push("with other colours of the directions".into());
    }
    Some((words, camera))
}

/// The row of the matrix that red (0) or green (1) tells where both pictures show the sky; blue
/// is 255 there.
fn fit_row(comparison: &Comparison, channel: usize) -> Option<DVec3> {
    let is_told = |pixel: &&Pixel| {
        pixel.is_sky() && pixel.yours[2] == 255 && (1..255).contains(&pixel.yours[channel])
    };
    let points = comparison.pixels.iter().filter(is_told).map(|pixel| {
        let place = DVec3::new(pixel.place.0.into(), pixel.place.1.into(), 1.0);
        (place, (f64::from(pixel.yours[channel]) / 255.0 - 0.7) / 0.3)
    });
    let points: Vec<_> = points.collect();
    let mut row = DVec3::ZERO;
    for limit in LIMITS {
        let (mut matrix, mut right, mut count) = (DMat3::ZERO, DVec3::ZERO, 0);
        for (place, value) in &points {
            if (row.dot(*place) - value).abs() < limit / 0.3 {
                matrix += DMat3::from_cols(*place * place.x, *place * place.y, *place);
                right += *place * *value;
                count += 1;
            }
        }
        if count < 100 || count * 2 < points.len() {
            return None;
        }
        row = matrix.inverse() * right;
    }
    row.is_finite().then_some(row)
}

/// The plainest number near a fitted one that is multiplied by up to `count`: ours, 0, ours and
/// so many twelfths of a pixel, ours times a short number, a short number, or itself.
fn plain_number(fitted: f64, ours: f64, pixel: f64, count: f64) -> f64 {
    let tolerance = LEAST_CHANGE / 76.5 / count;
    let short = |number: f64, digits: i32| {
        let scale = 10_f64.powi(digits);
        (number * scale).round() / scale
    };
    let is_near = |one: &f64, part: f64| (one - fitted).abs() < tolerance / part;
    let shifted = (-12..=12).map(|k| ours + f64::from(k) / 12.0 * pixel);
    let times = (0..=3).map(|digits| ours * short(fitted / ours, digits));
    let shorts = (0..=5).map(|digits| short(fitted, digits));
    let same = |part: f64| [ours, 0.0].into_iter().find(|one| is_near(one, part));
    let mut shifted = shifted.filter(|one| is_near(one, 10.0));
    let mut plain = times.chain(shorts).filter(|one| is_near(one, 3.0));
    let same_or_shifted = same(5.0).or_else(|| shifted.next()).or_else(|| same(1.0));
    same_or_shifted.or_else(|| plain.next()).unwrap_or(fitted)
}

/// A number with about four significant digits.
fn format_decimals(number: f64) -> String {
    let digits = if number.abs() < 0.1 { 6 } else { 4 };
    let text = format!("{:.digits$}", if number.abs() < 1e-6 { 0.0 } else { number });
    text.trim_end_matches('0').trim_end_matches('.').replace('-', "−")
}
