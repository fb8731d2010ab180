//! What a picture tells of the program that drew it, stage after stage.

use crate::{Section, Step};
use glam::DMat3;
use image::RgbImage;

mod bytes;
mod least;
mod sky;
mod words;

mod eye;
mod flat;
mod knobs;
mod local;
mod look;
mod nearest;
mod outlines;
mod rays;

mod alternatives;
mod classes;
mod light;
mod pixel;
mod shading;

use alternatives::{Alternative, alternatives};
use bytes::Bytes;
use eye::Eye;
use least::Least;
use light::{Fit, Terms};
use look::{Look, Place, hit};
pub use pixel::pixel;
use sky::Sky;

/// One stage on the way from a ray to three bytes, and what a picture tells of it.
#[derive(Clone, Debug)]
pub struct Stage {
    /// What it is called in the table.
    pub name: &'static str,
    /// Whether it is right.
    pub verdict: Verdict,
    /// Whole sentences with numbers, theirs and ours.
    pub numbers: Vec<String>,
    /// The section of the book to go back to.
    pub section: Section,
    /// The function of `tests/by_hand.rs` that would show it.
    pub test: Option<&'static str>,
}

/// What a picture tells of a stage.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every pixel that shows it agrees.
    Right,
    /// The numbers show that it is wrong.
    Wrong,
    /// It can't be told from this picture, and why.
    Unknown(String),
}

/// The stages of `step`, in order, as a picture of that step tells them.
pub fn stages(yours: &RgbImage, step: Step) -> Vec<Stage> {
    if yours.width() < 2 {
        return vec![];
    }
    let mut look = Look::new(yours, step);
    let mut stages = rays::stages(&look);
    if Step::Sphere <= step {
        stages.push(outlines::stage(&mut look));
        let before = stages.len();
        let places = look.places();
        if step <= Step::Nearest {
            stages.extend(flat::stages(&look, &places));
        } else {
            stages.extend(shading::stages(&mut look, &places));
        }
        settle(&look, &mut stages, before);
        doubt(&look, &mut stages);
        // Where the shapes are not known, the light can't be.
        if !look.has_shapes {
            for stage in &mut stages[before..] {
                let why = "the outlines have to be right first".to_owned();
                stage.verdict = Verdict::Unknown(why);
                stage.numbers.clear();
            }
        }
    }
    stages.push(bytes::stage(&look));
    stages
}

/// A sky of another colour is known only where the objects have theirs; elsewhere all
/// bytes may be others.
fn doubt(look: &Look, stages: &mut [Stage]) {
    let is_its = |s: &Stage| ["colours", "ambient"].contains(&s.name);
    let is_right = |s: &Stage| is_its(s) && s.verdict == Verdict::Right;
    if look.tint != DMat3::IDENTITY && !stages.iter().any(is_right) {
        let why = "the objects are other ones, too: all bytes may be";
        for stage in stages.iter_mut().filter(|stage| stage.name == "sky") {
            stage.verdict = Verdict::Unknown(why.to_owned());
        }
    }
}

/// Where there is no sky, outlines are known only if they explain the light; and a
/// formula that the light tells tells the outlines, too.
fn settle(look: &Look, stages: &mut [Stage], before: usize) {
    if look.step < Step::Diffuse || stages[before - 1].verdict != Verdict::Wrong {
        return;
    }
    let is_ambient =
        |s: &&Stage| s.name == "ambient" && s.verdict == Verdict::Right;
    if look.eye == Eye::Unknown && !stages.iter().any(|s| is_ambient(&s)) {
        for stage in &mut stages[before - 1..] {
            let why =
                "no part of the picture is the sky of any camera that is known";
            stage.verdict = Verdict::Unknown(why.to_owned());
            stage.numbers.clear();
        }
        return;
    }
    let point = stages.iter().position(|s| s.name == "point and normal");
    let Some(point) = point.filter(|&k| stages[k].verdict == Verdict::Wrong) else {
        return;
    };
    if stages[point].section.step < Step::Diffuse {
        let numbers = std::mem::take(&mut stages[point].numbers);
        let why = "it is wrong as the outlines are".to_owned();
        stages[point].verdict = Verdict::Unknown(why);
        stages[before - 1].section = stages[point].section;
        stages[before - 1].numbers.truncate(1);
        stages[before - 1].numbers.extend(numbers);
    }
}
