//! The numbers that `{{#value …}}` puts into a chapter, computed when the book is built.
//!
//! - `LIVE:NAME` is a number of a figure at its defaults, such as `row:D`;
//! - `LIVE:I,J:NAME` is one of the trace of a pixel, such as `step04_diffuse:470,120:t`;
//! - `NAME` is a count over the rays or pixels of a whole picture, or their largest change.
//!
//! A minus is one (−); code and formulas get a hyphen where it is put in.

use crate::fault::{ChapterError, ChapterResult};
use course::{camera, largest_channel_difference, primary_rays, ungated_colour};
use figures::{discriminant, format_count};
use step02_sphere::{Ray, SPHERE};
use step03_nearest::{OBJECTS, nearest};
use step05_phong::{picture, render, scene};

/// The text of `{{#value …}}`.
pub fn value_text(text: &str) -> ChapterResult<String> {
    let number = match text.split_once(':') {
        Some((live, number)) => live_number_text(live, number),
        None => count(text).map(format_count),
    };
    number.ok_or_else(|| ChapterError::UnknownValue(text.to_owned()))
}

/// The count of this name.
fn count(name: &str) -> Option<usize> {
    Some(match name {
        "step02-touches" => count_rays(|ray| discriminant(&SPHERE, ray) == 0.0),
        "step02-normalised" => {
            let unit_ray = |ray: &Ray| Ray { direction: ray.direction.normalize(), ..*ray };
            let has_hit = |ray: &Ray| SPHERE.intersect(ray).first_hit().is_some();
            count_rays(|ray| has_hit(ray) != has_hit(&unit_ray(ray)))
        }
        "step03-hits" => primary_rays().map(|ray| hit_indices(&ray).count()).sum(),
        "step03-last" => count_rays(|ray| {
            let nearest = nearest(&OBJECTS, ray).map(|hit| hit.object);
            hit_indices(ray).last().map(|k| &OBJECTS[k]) != nearest
        }),
        // The sphere behind the eye: its roots are below 0.
        "step03-behind" => count_rays(|ray| 0.0 <= discriminant(&OBJECTS[4].sphere, ray)),
        "step05-gate-pixels" => changes_without_gate().len(),
        "step05-gate-most" => changes_without_gate().into_iter().max().unwrap_or(0),
        _ => return None,
    })
}

/// A number such as `D` of a live figure at its defaults, or such as `470,120:t` of a
/// picture with a probe.
fn live_number_text(live: &str, number: &str) -> Option<String> {
    let live = figures::find(live)?;
    let mut values = live.default_values();
    let mut name = number;
    if let Some((pixel, traced)) = number.split_once(':')
        && live.has_probe()
    {
        let (i, j) = pixel.split_once(',')?;
        values[..2].copy_from_slice(&[i.parse().ok()?, j.parse().ok()?]);
        name = traced;
    }
    let is_allowed = live.snap_if_allowed(&values)? == values;
    is_allowed.then(|| (live.numbers)(&values).remove(name))?
}

fn count_rays(predicate: impl Fn(&Ray) -> bool) -> usize {
    primary_rays().filter(predicate).count()
}

/// The places in the list of the objects that a ray meets.
fn hit_indices(ray: &Ray) -> impl Iterator<Item = usize> {
    let has_hit = |k: &usize| OBJECTS[*k].sphere.intersect(ray).first_hit().is_some();
    (0..OBJECTS.len()).filter(has_hit)
}

/// How far each pixel changes without the test of n·l, where it does.
fn changes_without_gate() -> Vec<usize> {
    let scene = scene();
    let ungated = render(&camera(), 1, |ray| ungated_colour(&scene, ray));
    let picture = picture(&camera(), 1);
    let pairs = picture.pixels().zip(ungated.pixels());
    let changes = pairs.map(|(a, b)| usize::from(largest_channel_difference(a, b)));
    changes.filter(|change| 0 < *change).collect()
}
