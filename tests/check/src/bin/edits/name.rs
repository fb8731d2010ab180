use crate::edit::Change;
use gallery::{Mistake, Parts, Step, mistakes};
use image::RgbImage;
use std::fmt;
use step01_rays::Camera;

/// A name that an answer gives to a picture.
pub struct Name {
    causes: Vec<&'static Mistake>,
    /// How many pixels it says that the name does not explain.
    left: usize,
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let names: Vec<_> = self.causes.iter().map(|cause| cause.name).collect();
        f.write_str(&names.join(" + "))
    }
}

impl Name {
    /// Those that an answer gives.
    pub fn all(text: &str) -> Vec<Self> {
        let is_name = |line: &&str| {
            line.contains("what you get when") || line.contains("same picture when")
        };
        let lines =
            text.lines().filter(|line| !line.starts_with(' ')).filter(is_name);
        lines.map(|line| Self { causes: causes(line), left: left(line) }).collect()
    }

    /// Whether nothing is left over.
    pub fn is_exact(&self) -> bool {
        self.left == 0
    }

    /// Whether it sends the reader to the files of all these changes.
    pub fn leads_to(&self, changes: &[Change]) -> bool {
        let leads = |change: &Change| {
            self.causes.iter().any(|cause| cause.section.path() == change.path())
        };
        changes.iter().all(leads)
    }

    /// What is not so: it does not explain the picture as it says, or hardly explains it.
    pub fn lie(&self, yours: &RgbImage, step: Step, text: &str) -> Option<String> {
        let (left, all) =
            (self.unexplained(yours, step, text), yours.pixels().len());
        match (left == self.left, left * 200 < all) {
            (true, true) => None,
            (true, false) => Some(format!("{self}, but for {left} pixels")),
            (false, _) => Some(format!("{self}: {left} pixels, not {}", self.left)),
        }
    }

    /// How many pixels it does not explain.
    fn unexplained(&self, yours: &RgbImage, step: Step, text: &str) -> usize {
        let (width, height) = yours.dimensions();
        let fov = number(text, "field of view is ").unwrap_or(60.0);
        let camera = Camera::new(width, height, fov.to_radians());
        let mut parts = Parts::right(&camera);
        self.causes.iter().for_each(|cause| (cause.change)(&mut parts));
        let rays = text.split_once(" rays a pixel");
        let samples =
            rays.and_then(|(before, _)| before.rsplit_once('×')?.1.parse().ok());
        let ours = parts.picture(step, samples.unwrap_or(1));
        ours.pixels()
            .zip(yours.pixels())
            .filter(|(ours, yours)| ours != yours)
            .count()
    }
}

/// The mistakes that a line names.
fn causes(line: &str) -> Vec<&'static Mistake> {
    let all: Vec<_> = mistakes().filter(|one| line.contains(one.when)).collect();
    let is_part = |one: &&&Mistake| {
        all.iter()
            .any(|other| other.when != one.when && other.when.contains(one.when))
    };
    all.iter().filter(|one| !is_part(one)).copied().collect()
}

/// How many pixels a line says that its mistakes do not explain.
fn left(line: &str) -> usize {
    number(line, " in all but ").unwrap_or(0.0) as usize
}

/// The number after these words.
fn number(text: &str, words: &str) -> Option<f64> {
    let (_, rest) = text.split_once(words)?;
    rest.split([' ', '°']).next()?.parse().ok()
}
