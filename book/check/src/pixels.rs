use crate::classes::{Seen, classes};
use crate::scenes::Scenes;
use crate::{Step, camera};
use image::RgbImage;

/// What is known of a picture of a step, pixel by pixel, row by row.
pub(crate) struct Pixels<'a> {
    pub step: Step,
    pub yours: &'a RgbImage,
    pub classes: Vec<Seen>,
    /// Whether each pixel is right.
    pub is_right: Vec<bool>,
    /// Whether it shows the sky that is there, behind all objects.
    pub shows_sky: Vec<bool>,
}

impl<'a> Pixels<'a> {
    pub fn new(step: Step, yours: &'a RgbImage, ours: &RgbImage) -> Self {
        let camera = camera(yours.width(), yours.height());
        let scenes = Scenes::right();
        let pairs = || yours.enumerate_pixels().zip(ours.pixels());
        let is_right = pairs().map(|((.., a), b)| a == b).collect();
        let shows_sky = pairs().map(|((i, j, pixel), _)| {
            scenes.pixel(Step::Rays, &camera.ray(i.into(), j.into())) == pixel.0
        });
        let shows_sky = shows_sky.collect();
        Self { step, yours, classes: classes(step, yours), is_right, shows_sky }
    }

    /// How many pixels are right, of those of a class, and how many these are.
    pub fn count(&self, is_in: impl Fn(&Seen) -> bool) -> (usize, usize) {
        let all = self.classes.iter().zip(&self.is_right);
        all.filter(|(seen, _)| is_in(seen)).fold((0, 0), |(right, all), (_, is)| {
            (right + usize::from(*is), all + 1)
        })
    }

    /// How many pixels of an object show the sky, and how many it has.
    pub fn missing(&self, k: usize) -> (usize, usize) {
        let all = self.classes.iter().zip(&self.shows_sky);
        let its = all.filter(|(seen, _)| seen.object == Some(k));
        its.fold((0, 0), |(sky, all), (_, is)| (sky + usize::from(*is), all + 1))
    }
}
