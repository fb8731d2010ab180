//! The numbers that `{{#value …}}` puts into a chapter, computed when the book is built.
//!
//! - `FIGURE:NAME` is a number of a figure that has its default parameters. An example is `row:D`.
//! - `FIGURE:I,J:NAME` is a number of a picture whose probe is at the pixel (I, J). An example is
//!   `step04_diffuse:470,120:t`.
//! - `R_d:OBJECT` is the R_d of an object in the scene. An example is `R_d:salmon sphere`.
//! - `NAME` is a number for a whole picture: a count of rays, hits or pixels, or the largest change
//!   of any pixel.
//!
//! A figure computes all its numbers together. The numbers are cached, since chapters use several
//! numbers of the same figure.

use crate::fault::{ChapterError, ChapterResult};
use course::{
    camera, colour_without_highlight_gate, discriminant, largest_channel_difference, primary_rays,
};
use figures::{Figure, Readouts, format_count};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::{Mutex, PoisonError};
use step02_sphere::{Ray, SPHERE};
use step03_nearest::{OBJECTS, nearest};
use step05_phong::{picture, render, scene};

/// How a number is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Notation {
    /// For sentences, with a minus sign (−).
    Prose,
    /// For code and LaTeX, with a hyphen in place of the minus sign.
    Code,
}

/// The values that the chapters use.
#[derive(Debug, Default)]
pub struct Values {
    /// The readouts computed so far, for each figure and pixel.
    readouts: Mutex<BTreeMap<FigureAndPixel, Readouts>>,
}

/// The name of a figure, and the pixel where the figure's probe is, such as `470,120`. None as the
/// pixel means that all parameters of the figure have their default values.
type FigureAndPixel = (String, Option<String>);

impl Values {
    /// Returns the text that replaces `{{#value name}}`.
    pub fn text(&self, name: &str, notation: Notation) -> ChapterResult<String> {
        let text = match name.split_once(':') {
            Some(("R_d", object)) => diffuse_reflectance_text(object),
            Some((figure, readout)) => self.readout(figure, readout),
            None => whole_picture_number(name).map(format_count),
        };
        let text = text.ok_or_else(|| ChapterError::UnknownValue(name.to_owned()))?;
        Ok(match notation {
            Notation::Prose => text,
            // The crate `figures` formats readouts only for prose, because a page never updates
            // numbers in code. Code needs a hyphen as the minus sign. In a readout, every − is the
            // sign of a number, so all of them can be replaced.
            Notation::Code => text.replace('−', "-"),
        })
    }

    /// Returns a readout of a figure, such as `D`. The figure's parameters have their default
    /// values. If the figure has a probe, however, `readout` may begin with a pixel, as in
    /// `470,120:t`, and the probe is then at that pixel.
    fn readout(&self, figure_name: &str, readout: &str) -> Option<String> {
        let figure = figures::find_figure(figure_name)?;
        let (pixel, readout) = match readout.split_once(':').filter(|_| figure.probe().is_some()) {
            Some((pixel, readout)) => (Some(pixel), readout),
            None => (None, readout),
        };
        let key = (figure_name.to_owned(), pixel.map(str::to_owned));
        let mut cache = self.readouts.lock().unwrap_or_else(PoisonError::into_inner);
        let readouts = match cache.entry(key) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => entry.insert(compute_readouts(figure, pixel)?),
        };
        readouts.get(readout).cloned()
    }
}

/// Computes all readouts of a figure whose probe is at `pixel`, such as `470,120`. If `pixel` is
/// None, the figure has its default parameters. Returns None if `pixel` isn't a pixel of the
/// figure.
fn compute_readouts(figure: &Figure, pixel: Option<&str>) -> Option<Readouts> {
    let values = match pixel {
        Some(pixel) => {
            let (i, j) = pixel.split_once(',')?;
            figure.default_values_with_probe_at([i.parse().ok()?, j.parse().ok()?])?
        }
        None => figure.default_values(),
    };
    Some((figure.readouts)(&values))
}

/// Computes the number called `name`, which describes a whole picture. Returns None for an unknown
/// name.
fn whole_picture_number(name: &str) -> Option<usize> {
    Some(match name {
        "step02-touches" => count_primary_rays(|ray| discriminant(&SPHERE, ray) == 0.0),
        "step02-normalised" => {
            let unit_ray = |ray: &Ray| Ray { direction: ray.direction.normalize(), ..*ray };
            let has_hit = |ray: &Ray| SPHERE.intersect(ray).first_hit().is_some();
            count_primary_rays(|ray| has_hit(ray) != has_hit(&unit_ray(ray)))
        }
        "step03-hits" => primary_rays().map(|ray| indices_of_hit_objects(&ray).count()).sum(),
        "step03-last" => count_primary_rays(|ray| {
            let nearest_object = nearest(&OBJECTS, ray).map(|hit| hit.object);
            indices_of_hit_objects(ray).last().map(|k| &OBJECTS[k]) != nearest_object
        }),
        // Object 4 is the sphere behind the eye. Rays meet this sphere only at negative t, and
        // `first_hit` ignores negative t, so this counts rays by their discriminants.
        "step03-behind" => count_primary_rays(|ray| discriminant(&OBJECTS[4].sphere, ray) >= 0.0),
        "step05-gate-pixels" => sizes_of_pixel_changes_without_gate().len(),
        "step05-gate-most" => sizes_of_pixel_changes_without_gate().into_iter().max().unwrap_or(0),
        _ => return None,
    })
}

/// Formats the R_d of an object. Returns None if the scene has no object with this name.
fn diffuse_reflectance_text(object: &str) -> Option<String> {
    let object = scene().objects.into_iter().find(|candidate| candidate.name == object)?;
    let [r, g, b] = object.material.matte.diffuse.to_array();
    Some(format!("({r}, {g}, {b})"))
}

fn count_primary_rays(predicate: impl Fn(&Ray) -> bool) -> usize {
    primary_rays().filter(predicate).count()
}

/// The indices, in `OBJECTS`, of the objects that a ray hits.
fn indices_of_hit_objects(ray: &Ray) -> impl Iterator<Item = usize> {
    let has_hit = |k: &usize| OBJECTS[*k].sphere.intersect(ray).first_hit().is_some();
    (0..OBJECTS.len()).filter(has_hit)
}

/// Draws step 5's picture without the gate (the test of n·l), and compares the result with the
/// correct picture. For each pixel that differs, returns the largest difference in any channel.
fn sizes_of_pixel_changes_without_gate() -> Vec<usize> {
    let scene = scene();
    let ungated = render(&camera(), 1, |ray| colour_without_highlight_gate(&scene, ray));
    let picture = picture(&camera(), 1);
    let pairs = picture.pixels().zip(ungated.pixels());
    let changes = pairs.map(|(a, b)| usize::from(largest_channel_difference(a, b)));
    changes.filter(|change| *change > 0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readouts_of_a_figure_are_computed_once() {
        let values = Values::default();
        values.text("step02_sphere:300,150:a0", Notation::Prose).expect("the value exists");
        // Change a text in the cache. This change would be lost if the readouts were computed
        // again.
        let key = ("step02_sphere".to_owned(), Some("300,150".to_owned()));
        let mut cache = values.readouts.lock().expect("the lock isn't poisoned");
        let readouts = cache.get_mut(&key).expect("the readouts of the pixel are cached");
        readouts.insert("b0".to_owned(), "kept".to_owned());
        drop(cache);
        assert_eq!(
            values.text("step02_sphere:300,150:b0", Notation::Prose).expect("the value exists"),
            "kept"
        );
        assert_eq!(
            values.text("step02_sphere:b0", Notation::Prose).expect("the value exists"),
            "−10"
        );
    }

    #[test]
    fn value_of_r_d_is_the_material_of_the_named_object() {
        for object in OBJECTS {
            let [r, g, b] = object.material.to_array();
            let text = Values::default().text(&format!("R_d:{}", object.name), Notation::Prose);
            assert_eq!(
                text.expect("the value exists"),
                format!("({r}, {g}, {b})"),
                "{}",
                object.name
            );
        }
        assert!(Values::default().text("R_d:no sphere", Notation::Prose).is_err());
    }
}
