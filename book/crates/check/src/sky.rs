//! What the sky of a picture tells: where nothing is hit, red is 0.7 + 0.3 V_x and green
//! 0.7 + 0.3 V_y, so that each channel is a plane over the picture.

use crate::evidence::{Evidence, Pixel};
use crate::explanation::{Explanation, range_with_margin};
use crate::step_scene::{ENCODE, intensity_function, scene_of_step};
use course::Step;
use glam::{DMat3, DVec3};
use step01_rays::Camera;

const CAMERA: &str = "step01_rays/camera.rs";
const SKY: &str = "step01_rays/direction_colour.rs";
const RGB8: &str = "step01_rays/rgb8.rs";

/// How far off a channel may be while its plane is fitted again; the last are little more
/// than what the rounding of a byte does.
const LIMITS: [f64; 7] = [0.006, 0.005, 0.004, 0.003, 0.0025, 0.0025, 0.0025];

/// The plane a·x + b·y + c on which most points (x, y, 1) have their values; None where
/// these are few.
fn fit_plane(points: &[(DVec3, f64)]) -> Option<DVec3> {
    if points.len() < 100 {
        return None;
    }
    let is_on = |plane: DVec3, limit: f64, (place, value): &(DVec3, f64)| {
        (plane.dot(*place) - value).abs() < limit
    };
    // The best of some planes through three points each.
    let samples: Vec<_> = points.iter().step_by(points.len().div_ceil(400)).collect();
    let through = |k: usize| {
        let three = [k, 7 * k + 131, 31 * k + 270].map(|n| samples[n * 17 % samples.len()]);
        let [p, q, r] = three.map(|point| point.0);
        let inverse = DMat3::from_cols(p, q, r).transpose().inverse();
        inverse.is_finite().then(|| inverse * DVec3::from_array(three.map(|point| point.1)))
    };
    let count = |plane: &DVec3| samples.iter().filter(|point| is_on(*plane, 0.004, point)).count();
    let mut plane = (0..400).filter_map(through).max_by_key(count)?;
    for limit in LIMITS {
        let (mut matrix, mut right, mut count) = (DMat3::ZERO, DVec3::ZERO, 0);
        for (x, value) in points.iter().filter(|point| is_on(plane, limit, point)) {
            matrix += DMat3::from_cols(*x * x.x, *x * x.y, *x * x.z);
            right += *x * *value;
            count += 1;
        }
        let inverse = matrix.inverse();
        if count * 5 < points.len() || !inverse.is_finite() {
            return None;
        }
        plane = inverse * right;
    }
    Some(plane)
}

/// The plane of a channel, where our own sky is and it was not clamped.
fn fit_channel_of_sky(
    evidence: &Evidence,
    channel: usize,
    place: impl Fn(&Pixel) -> DVec3,
) -> Option<DVec3> {
    let sky = evidence.pixels.iter().filter(|pixel| pixel.is_sky());
    let inner = sky.clone().filter(|one| (1..255).contains(&one.yours[channel]));
    let point = |one: &Pixel| (place(one), f64::from(one.yours[channel]) / 255.0);
    let points: Vec<_> = inner.map(point).collect();
    match points.len() * 4 < sky.clone().count() {
        // All of it may have been clamped.
        true => Some(DVec3::Z * point(sky.clone().next()?).1),
        false => fit_plane(&points),
    }
}

/// How far a byte of the sky has to be off, somewhere, by another number of the camera.
const MIN_CHANGE_TO_REPORT: f64 = 0.1;

/// How far from the middle of a pixel a fitted camera may be.
const MAX_PIXEL_OFFSET: f64 = 0.3;

/// Explanation, not yet tried: our step with the camera that the sky tells. Its z leaves no
/// trace there.
pub(crate) fn camera_candidate(evidence: &Evidence) -> Option<Explanation<'_>> {
    let (step, ours) = (evidence.step?, evidence.camera);
    let row = |channel| {
        let place = |pixel: &Pixel| DVec3::new(pixel.i.into(), pixel.j.into(), 1.0);
        let plane = fit_channel_of_sky(evidence, channel, place)?;
        Some((plane - 0.7 * DVec3::Z) / 0.3)
    };
    let mut rows = [row(0)?, row(1)?, ours.matrix.row(2)];
    let mut clauses = vec![];
    for (k, name) in ["D_u", "D_v", "V_0"].into_iter().enumerate() {
        let count = f64::from([ours.h_res, ours.v_res, 1][k]);
        let right = [0, 1].map(|y| ours.matrix.row(y)[k]);
        for (y, right) in right.into_iter().enumerate() {
            // A difference below the threshold is none.
            if (rows[y][k] - right).abs() * count * 76.5 < MIN_CHANGE_TO_REPORT {
                rows[y][k] = right;
            }
        }
        let yours = [rows[0][k], rows[1][k]];
        if yours != right {
            let [[a, b], [c, d]] = [yours, right].map(|pair| pair.map(format_4_or_6_decimals));
            clauses.push(format!("x and y of {name} are ({a}, {b}), not ({c}, {d})"));
        }
    }
    if clauses.is_empty() {
        return None;
    }
    let caveat = match step {
        Step::Rays => {
            " (That is, if red is 0.7 + 0.3 V_x and green 0.7 + 0.3 V_y, as in direction_colour.rs.)"
        }
        _ => "",
    };
    let sentence = format!(
        "Your picture is what our step draws with another camera: {}.{caveat}",
        clauses.join("; ")
    );
    let files = if step == Step::Rays { &[CAMERA, SKY][..] } else { &[CAMERA] };
    let [x, y, z] = rows;
    let matrix = DMat3::from_cols(x, y, z).transpose();
    let camera = Camera { matrix, ..ours };
    let intensity = intensity_function(step, &scene_of_step(step));
    let mut explanation = Explanation::within_range(sentence, files, move |pixel| {
        let (i, j) = (f64::from(pixel.i), f64::from(pixel.j));
        let offsets = [0.0, MAX_PIXEL_OFFSET, -MAX_PIXEL_OFFSET].map(|slack| {
            [(i + slack, j), (i, j + slack)].map(|(i, j)| ENCODE(intensity(&camera.ray(i, j))))
        });
        range_with_margin(offsets.as_flattened(), 1)
    });
    explanation.rays = 6;
    // An edge may lie between two of these places: some pixels may differ.
    explanation.exceptions = 2000;
    Some(explanation)
}

/// A number with four significant decimals.
fn format_4_or_6_decimals(number: f64) -> String {
    let number = if number.abs() < 1e-6 { 0.0 } else { number };
    let digits = if number.abs() < 0.1 { 6 } else { 4 };
    let text = format!("{number:.digits$}").replace('-', "−");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Explanations, not yet tried: the sky of another colour, whose channels are planes in V
/// or in V/|V|; objects as ours.
pub(crate) fn sky_colour_candidates(evidence: &Evidence) -> impl Iterator<Item = Explanation<'_>> {
    let is_asked = evidence.step.is_some() && evidence.wrong_pixels().iter().all(Pixel::is_sky);
    let directions = ["V", "V/|V|"].into_iter().filter(move |_| is_asked);
    directions.filter_map(move |name| {
        let place = move |pixel: &Pixel| {
            let v = evidence.our_ray(pixel).direction;
            let v = if name == "V" { v } else { v.normalize() };
            DVec3::new(v.x, v.y, 1.0)
        };
        let fit = |channel| fit_channel_of_sky(evidence, channel, place);
        let planes = [fit(0)?, fit(1)?, fit(2)?];
        let words = [0, 1, 2].map(|k| format_channel_plane(k, planes[k]));
        let (is_alone, else_right) = match evidence.step {
            Some(Step::Rays) => (true, ""),
            _ => (false, ", and all else is right"),
        };
        let sentence = format!(
            "Your sky has another colour{else_right}: {}, where (x, y) is that of {name}.",
            words.join(", ")
        );
        // A V that is longer, but not another way, looks the same.
        let is_scaled = planes[..2].iter().all(|plane| (plane.z - 0.7).abs() < 0.01);
        let files: &[_] = match (is_alone, is_scaled) {
            (_, true) => &[SKY, CAMERA],
            (true, _) => &[SKY, RGB8],
            _ => &[SKY],
        };
        Some(Explanation::within_range(sentence, files, move |pixel| {
            let colour = match pixel.is_sky() {
                true => planes.map(|plane| (255.0 * plane.dot(place(pixel))).round() as u8),
                false => return [pixel.ours; 2],
            };
            range_with_margin(&[colour], 1)
        }))
    })
}

fn format_channel_plane(channel: usize, plane: DVec3) -> String {
    let decimals = |number: f64| format!("{number:.2}").replace('-', "−");
    let name = ["red", "green", "blue"][channel];
    let mut text = format!("{name} = {}", decimals(plane.z));
    for (number, letter) in [(plane.x, "x"), (plane.y, "y")] {
        if number.abs() > 0.005 {
            let sign = if number < 0.0 { "−" } else { "+" };
            text += &format!(" {sign} {} {letter}", decimals(number.abs()));
        }
    }
    text
}
