use super::Black;
use crate::fov::{FOV, fields_of_view, likeliest};
use crate::view::{View, scattered};
use crate::{Options, Step, each, key, sort};
use image::RgbImage;

/// As many rays as are cast at most to explain a picture: four for each pixel of 640×360.
const RAYS: u32 = 4 * 640 * 360;

impl Options {
    /// Of how many pixels one is looked at, as very many rays are not worth the wait.
    pub fn one_of(&self, yours: &RgbImage) -> u32 {
        let pixels = yours.pixels().len() / stride(yours).pow(2);
        (pixels as u32 * self.samples * self.samples).div_ceil(RAYS)
    }

    /// Whether all pixels of a picture are looked at.
    pub fn is_whole(&self, yours: &RgbImage) -> bool {
        self.one_of(yours) == 1 && stride(yours) == 1
    }

    /// In how many of some pixels a picture differs from ours with these options.
    pub fn misses(&self, step: Step, yours: &RgbImage) -> usize {
        let samples = self.samples;
        let parts = self.cause(step).parts(yours.dimensions());
        let differs = |&(i, j): &(u32, u32)| {
            *yours.get_pixel(i, j) != parts.pixel(step, samples, i, j)
        };
        let count = |some: &[_]| Some(some.iter().filter(|at| differs(at)).count());
        each(scattered(yours, 3000).chunks(500).collect(), count).iter().sum()
    }

    /// How far the shares of the sky in some pixels, which are mixed of it and an object,
    /// are from those that so many rays have; None where too few pixels tell it.
    fn off(self, step: Step, yours: &RgbImage, mixed: &[Mixed]) -> Option<f64> {
        let parts = self.cause(step).parts(yours.dimensions());
        let is_sky = |i: f64, j: f64| {
            parts.seen(step, &(parts.ray)(parts.camera.ray(i, j))).is_none()
        };
        let side = f64::from(self.samples);
        let offset = |k: u32| (f64::from(k) + 0.5) / side - 0.5;
        let mut all = vec![];
        for (place, left) in mixed.iter().step_by(mixed.len() / 100 + 1) {
            let (x, y) = (f64::from(place.0), f64::from(place.1));
            let sides = [is_sky(x - 2.0, y), is_sky(x + 2.0, y)];
            if sides[0] == sides[1] {
                continue;
            }
            let mut share = 0.0;
            for k in 0..self.samples * self.samples {
                let (u, v) = (offset(k % self.samples), offset(k / self.samples));
                if is_sky(x + u, y + v) {
                    share += 1.0 / (side * side);
                }
            }
            let theirs = if sides[0] { *left } else { 1.0 - left };
            all.push((theirs - share).abs());
        }
        median(all)
    }

    /// Whether the shares of the colours in mixed pixels are those of so many rays.
    /// By chance they are off by a quarter, more or less.
    fn is_grid(self, mixed: &[Mixed]) -> bool {
        let rays = f64::from(self.samples.pow(2));
        let off = |(_, left): &Mixed| (left * rays - (left * rays).round()).abs();
        median(mixed.iter().map(off).collect()).is_some_and(|off| off < 0.17)
    }
}

/// A pixel between two others, and the share of the left one's colour in its own.
type Mixed = ((u32, u32), f64);

/// The one in the middle of enough numbers.
fn median(mut all: Vec<f64>) -> Option<f64> {
    sort(&mut all, |one| key(*one));
    all.get(all.len() / 2).copied().filter(|_| 7 < all.len())
}

/// The likeliest first: the defaults.
pub(super) fn views(yours: &RgbImage, is_smooth: bool) -> Vec<Options> {
    let whole = View::whole(yours.clone());
    let others = fields_of_view(&whole);
    let other = likeliest(&whole, others);
    let samples: &[u32] = if is_smooth { &[2, 3, 4, 1, 5, 6, 7, 8] } else { &[1] };
    let (mut fovs, mut all) = (vec![FOV], vec![]);
    fovs.extend(other);
    for fov in fovs {
        for &samples in samples {
            all.push(Options { fov, samples });
        }
    }
    all
}

/// Of each field of view two or three numbers of samples: the one that outlines tell, and
/// those with which ours is nearest; the course's own angle first, as another one explains
/// too much.
pub(super) fn likely(yours: &RgbImage, step: Step) -> Vec<Options> {
    let mixed = mixed(yours);
    // Blurred edges may be of samples that are too far apart.
    let all = views(yours, mixed.is_some() || is_blurred(yours));
    let mixed = mixed.unwrap_or_default();
    let mut likely = vec![];
    for of_fov in all.chunk_by(|a, b| a.fov == b.fov) {
        let mut told = vec![];
        for view in of_fov {
            told.extend(view.off(step, yours, &mixed).map(|off| (off, *view)));
        }
        sort(&mut told, |(off, _)| key(*off));
        let first = match told[..] {
            [(least, first), (next, _), ..] if 1.5 * least < next => Some(first),
            _ => of_fov.iter().take(3).find(|view| view.is_grid(&mixed)).copied(),
        };
        let mut some = of_fov[..of_fov.len().min(4)].to_vec();
        if 1 < some.len() {
            sort(&mut some, |view| [view.misses(step, yours), 0]);
        }
        let mut most = 2;
        if let Some(first) = first {
            some.retain(|view| *view != first);
            some.insert(0, first);
        } else if let Some(at) = some.iter().skip(2).position(|v| v.samples == 1) {
            // Nothing tells it: it may well be one.
            some.swap(2, 2 + at);
            most = 3;
        }
        some.truncate(most);
        likely.extend(some);
    }
    likely
}

/// The pixels along sharp edges that are mixed of two colours; None where others are not,
/// as with one ray a pixel.
pub(super) fn mixed(yours: &RgbImage) -> Option<Vec<Mixed>> {
    let (mut edges, mut mixed) = (0, vec![]);
    for j in 0..yours.height() {
        for i in 2..yours.width() - 2 {
            let at = |i: u32| yours.get_pixel(i, j);
            let apart = |a: u32, b: u32| crate::apart(at(a), at(b));
            // Two even sides, and one pixel between them.
            let is_even = apart(i - 2, i - 1) < 4 && apart(i + 1, i + 2) < 4;
            if is_even && 40 < apart(i - 1, i + 1) {
                edges += 1;
                if 8 < apart(i - 1, i).min(apart(i, i + 1)) {
                    let all = [i - 1, i, i + 1].map(|i| at(i).0.map(f64::from));
                    let apart = |k: &usize| (all[0][*k] - all[2][*k]).abs() as u8;
                    let k = (0..3).max_by_key(apart).unwrap_or(0);
                    let left = (all[1][k] - all[2][k]) / (all[0][k] - all[2][k]);
                    mixed.push(((i, j), left));
                }
            }
        }
    }
    (edges < 5 * mixed.len() && 3 < mixed.len()).then_some(mixed)
}

/// Whether most edges are wider than the one pixel that the rays through it mix.
pub(super) fn is_blurred(yours: &RgbImage) -> bool {
    let (mut sharp, mut wide) = (0, 0);
    for j in 0..yours.height() {
        for i in 3..yours.width() {
            let at = |k: u32| yours.get_pixel(i - k, j);
            let steps = [0, 1, 2].map(|k| crate::apart(at(k), at(k + 1)));
            let all = u32::from(crate::apart(at(0), at(3)));
            let is_most = |share: u32| {
                steps.iter().any(|step| share * all < 10 * u32::from(*step))
            };
            sharp += u32::from(40 < all && is_most(8));
            let is_slope = !is_most(6) && steps.iter().all(|step| 8 < *step);
            wide += u32::from(40 < all && is_slope);
        }
    }
    sharp + 20 < wide
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
