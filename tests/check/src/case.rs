use crate::turned::turned;
use crate::view::View;
use crate::{Cause, Found, Locked, Options, Rest, Step, camera, recognise, whose};
use image::RgbImage;

/// The most rays that are worth the wait for a very large picture: one for each pixel of
/// the largest.
const MOST: usize = 16384 * 16384;

/// The most rays that our picture is drawn with: four for each pixel of 640×360.
const FEW: usize = 1_000_000;

/// So few pixels are a slip of the mouse, and no mistake of a program.
const STRAYS: usize = 12;

/// A picture that is not right, and what is found out about it before it is measured.
pub(crate) struct Case<'a> {
    /// The picture.
    pub yours: &'a View,
    /// What it is taken for.
    pub ours: &'a Locked,
    /// The same, if it is a step's picture and our own code still draws that.
    pub step: Option<Step>,
    /// The steps asked for whose code in our folder does not draw their pictures.
    pub broken: Vec<Step>,
    /// Another locked picture that it is in every pixel.
    pub same: Option<&'a Locked>,
    /// The known mistakes that explain it.
    pub found: Option<Found>,
}

impl<'a> Case<'a> {
    /// That of a picture that should be one of those `asked` for, of which there is at
    /// least one.
    pub fn of(
        yours: &'a View,
        asked: &[&'a Locked],
        same: Option<&'a Locked>,
    ) -> Self {
        let steps =
            asked.iter().filter_map(|one| Some((*one, Step::named(&one.name)?)));
        let (broken, known): (Vec<_>, Vec<_>) =
            steps.partition(|(one, step)| is_broken(one, *step));
        let [broken, known] = [broken, known].map(|list| -> Vec<Step> {
            list.into_iter().map(|(_, step)| step).collect()
        });
        // What is right elsewhere is not nearly something else here.
        let is_clear = |found: &Found| found.rest.is_none() || same.is_none();
        let found = recognise(yours, &known)
            .or_else(|| asked.iter().find_map(|ours| turned(yours, ours)))
            .filter(is_clear);
        let is_found = |one: &&&Locked| {
            found.as_ref().is_none_or(|found| found.name == one.name)
        };
        let nearest = asked.iter().copied().filter(|one| is_found(&one));
        let ours = nearest.min_by_key(|ours| whose::distance(yours, ours));
        let ours = ours.unwrap_or(asked[0]);
        let step = Step::named(&ours.name).filter(|step| !broken.contains(step));
        Self { yours, ours, step, broken, same, found }
    }

    /// Looks at all pixels of a picture of which only some are kept, where the known
    /// mistakes explain these, and that does not take too many rays.
    pub fn recount(&mut self, recount: impl FnOnce(&Cause) -> Option<Rest>) {
        let is_kept = self.yours.stride == 1;
        let rays =
            |found: &Found| self.yours.pixels() * found.samples.pow(2) as usize;
        let found =
            self.found.as_ref().filter(|found| !is_kept && rays(found) <= MOST);
        let cause =
            found.and_then(|found| Some(found.cause(Step::named(&found.name)?)));
        if let (Some(found), Some(cause)) = (&mut self.found, cause) {
            found.rest = recount(&cause).unwrap_or_else(|| found.rest.clone());
        }
    }

    /// Whether it is known how every pixel came about.
    pub fn is_explained(&self) -> bool {
        self.found.as_ref().is_some_and(|found| found.rest.is_none())
    }

    /// Whether what is not explained is so little that it tells of no stage.
    pub fn has_strays_only(&self) -> bool {
        self.found.as_ref().is_some_and(|found| found.rest.beyond(0) <= STRAYS)
    }

    /// Whether nothing is wrong with the picture but its size, its rays or single
    /// pixels.
    pub fn is_nearly_right(&self) -> bool {
        self.found.as_ref().is_some_and(|found| found.causes[0].is_empty())
    }

    /// Our picture at the size of the reader's, where there is anything to show: a
    /// step's own is drawn anew at another size, or with options.
    pub fn drawn(&self, mut options: Options) -> Option<RgbImage> {
        let Self { yours, ours, .. } = self;
        if self.is_explained() && self.is_nearly_right() {
            return None;
        }
        // Very many rays are not worth the wait.
        if FEW < yours.kept.pixels().len() * options.samples.pow(2) as usize {
            options.samples = 1;
        }
        if yours.size == ours.picture.dimensions() && options == Options::NONE {
            return Some(ours.picture.clone());
        }
        let step = self.step.filter(|_| 2 <= yours.size.0)?;
        let parts = options.cause(step).parts(yours.size);
        if yours.stride == 1 {
            return Some(parts.picture(step, options.samples));
        }
        let (columns, rows) = yours.kept.dimensions();
        Some(RgbImage::from_fn(columns, rows, |i, j| {
            let (i, j) = (i * yours.stride, j * yours.stride);
            parts.pixel(step, options.samples, i, j)
        }))
    }
}

/// Whether the code of a step does not draw its locked picture; in a page, it has.
fn is_broken(ours: &Locked, step: Step) -> bool {
    let (width, height) = ours.picture.dimensions();
    !cfg!(target_arch = "wasm32")
        && step.picture(&camera(width, height), 1) != ours.picture
}
