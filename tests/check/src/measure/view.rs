use super::Black;
use crate::fov::{FOV, fields_of_view, has_sky};
use crate::view::{View, scattered};
use crate::{Options, Step, sort};
use image::RgbImage;

impl Options {
    /// Of how many pixels one is looked at: as many as with four rays a pixel, as more
    /// rays are not worth the wait.
    pub fn one_of(&self) -> u32 {
        (self.samples * self.samples).div_ceil(4)
    }

    /// Whether all pixels of a picture are looked at.
    pub fn is_whole(&self, yours: &RgbImage) -> bool {
        self.one_of() == 1 && stride(yours) == 1
    }

    /// In how many of some pixels a picture differs from ours with these options.
    pub fn misses(&self, step: Step, yours: &RgbImage) -> usize {
        let samples = self.samples;
        let parts = self.cause(step).parts(yours.dimensions());
        let differs = |&(i, j): &(u32, u32)| {
            *yours.get_pixel(i, j) != parts.pixel(step, samples, i, j)
        };
        scattered(yours, 3000).into_iter().filter(differs).count()
    }
}

/// The likeliest first: the defaults.
pub(super) fn views(yours: &RgbImage) -> Vec<Options> {
    let whole = View::whole(yours.clone());
    let others = fields_of_view(&whole).into_iter();
    let fovs =
        [FOV].into_iter().chain(others.filter(|fov| has_sky(&whole, *fov)).take(1));
    let samples: &[u32] = if is_smooth(yours) { &[2, 3, 4, 1] } else { &[1] };
    let all = fovs.flat_map(|fov| {
        samples.iter().map(move |&samples| Options { fov, samples })
    });
    all.collect()
}

/// Of each field of view the two numbers of samples with which ours is nearest; the
/// course's own angle first, as another one explains too much.
pub(super) fn likely(yours: &RgbImage, step: Step) -> Vec<Options> {
    let all = views(yours);
    let of_fov = all.chunk_by(|a, b| a.fov == b.fov).flat_map(|some| {
        let mut some = some.to_vec();
        if 1 < some.len() {
            sort(&mut some, |view| [view.misses(step, yours), 0]);
        }
        some.into_iter().take(2)
    });
    of_fov.collect()
}

/// Whether the pixels along sharp edges are mixed of two colours, as with more rays a
/// pixel.
fn is_smooth(yours: &RgbImage) -> bool {
    let (mut edges, mut mixed) = (0, 0);
    for j in 0..yours.height() {
        for i in 2..yours.width() - 2 {
            let at = |i: u32| yours.get_pixel(i, j);
            let apart = |a: u32, b: u32| crate::apart(at(a), at(b));
            // Two even sides, and one pixel between them.
            let is_even = apart(i - 2, i - 1) < 4 && apart(i + 1, i + 2) < 4;
            if is_even && 40 < apart(i - 1, i + 1) {
                edges += 1;
                let is_mixed = 8 < apart(i - 1, i).min(apart(i, i + 1));
                mixed += usize::from(is_mixed);
            }
        }
    }
    edges < 3 * mixed && 3 < mixed
}

/// All pixels, or some 200,000 of them where there are many more; none of a black line.
pub(super) fn places(yours: &RgbImage, black: Option<&Black>) -> Vec<(u32, u32)> {
    let ((width, height), stride) = (yours.dimensions(), stride(yours));
    let mut places = vec![];
    for j in (0..height).step_by(stride) {
        for i in (0..width).step_by(stride) {
            if black.is_none_or(|black| !black.has((i, j))) {
                places.push((i, j));
            }
        }
    }
    places
}

/// Of how many columns, and rows, one is looked at.
fn stride(yours: &RgbImage) -> usize {
    let all = u64::from(yours.width()) * u64::from(yours.height());
    (all / 260_000).isqrt() as usize + 1
}
