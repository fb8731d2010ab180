use crate::{Parts, Section, Step, camera};
use image::RgbImage;
use step01_rays::Camera;

/// One thing done wrong, and what is known of it.
#[derive(Clone, Copy, Debug)]
pub struct Mistake {
    /// Its name in file names: lower-case words with `-` between them.
    pub name: &'static str,
    /// The step in whose picture it is first told from the others: that of its section,
    /// or a later one.
    pub step: Step,
    /// The section of the book to go back to; its step is the one whose code is wrong,
    /// although the mistake may not show before a later one.
    pub section: Section,
    /// What is wrong, to be read after "the picture is what you get when".
    pub when: &'static str,
    /// What the picture shows, in one sentence.
    pub sees: &'static str,
    /// How it comes about or what is right, in one sentence.
    pub says: &'static str,
    /// Replaces the one part.
    pub change: fn(&mut Parts),
}

/// What the book says alone: the module of a page holds no such words.
pub(crate) const fn book(words: &'static str) -> &'static str {
    if cfg!(target_arch = "wasm32") { "" } else { words }
}

impl Mistake {
    /// The picture of its step with this mistake in it.
    pub fn picture(&self, camera: &Camera, samples: u32) -> RgbImage {
        self.picture_in(self.step, camera, samples)
    }

    /// The picture of any step with this mistake in it: a later one keeps it.
    pub fn picture_in(
        &self,
        step: Step,
        camera: &Camera,
        samples: u32,
    ) -> RgbImage {
        let mut parts = Parts::right(camera);
        (self.change)(&mut parts);
        parts.picture(step, samples)
    }

    /// Its picture in `step` as the book shows it.
    pub fn show(&self, step: Step) -> RgbImage {
        self.picture_in(step, &camera(320, 180), 2)
    }

    /// The steps in whose pictures the book shows it, and the names of those pictures.
    pub fn shown(&self) -> impl Iterator<Item = (Step, String)> {
        let own = (self.step, format!("mistake-{}", self.name));
        let last = (Step::Phong, format!("mistake-{}-in-step-5", self.name));
        [Some(own), (self.step == Step::Rays).then_some(last)].into_iter().flatten()
    }
}
