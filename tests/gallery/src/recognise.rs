use crate::difference::apart;
use crate::{Cause, Parts, Step};
use image::RgbImage;
use std::cmp::Reverse;

/// What is known of a picture.
#[derive(Clone, Debug)]
pub struct Found {
    /// The causes that give it; several, where several give the same picture.
    pub causes: Vec<Cause>,
    /// How many of the compared pixels differ from what they give: of all, unless
    /// they take very many rays.
    pub rest: usize,
}

/// About how many rays are cast at most to compare a picture with one cause.
const RAYS: u64 = 1_000_000;

/// A channel that is off by this much may be so by rounding.
const ROUNDING: u8 = 2;

/// Finds out how a picture came about in one of `steps`, or None where that is unknown.
///
/// Few pixels sort out nearly all causes; all pixels decide. The fewest mistakes win.
/// A cause that leaves pixels unexplained is found only where these are few: less than
/// one in 200, and than a tenth of those that it explains.
pub fn recognise(yours: &RgbImage, steps: &[Step]) -> Option<Found> {
    if yours.width() < 2 {
        return None;
    }
    let mut likely = vec![];
    for count in 0..=2 {
        let all = steps.iter().flat_map(|&step| Cause::all(step, count));
        let mut level = sieved(yours, all.collect());
        level.sort_by_key(|(misses, _)| *misses);
        let more = || exact(yours, &with_more_rays(yours, &level));
        if let Some(found) = exact(yours, &level).or_else(more) {
            return Some(found);
        }
        likely.append(&mut level);
    }
    likely.sort_by_key(|(misses, cause)| (*misses, cause.mistakes.len()));
    let likely = with_more_rays(yours, &likely);
    exact(yours, &likely).or_else(|| near(yours, &likely))
}

type Rated = (usize, Cause);

/// The causes that explain most of a few hundred pixels, and of the first few of them.
fn sieved(yours: &RgbImage, causes: Vec<Cause>) -> Vec<Rated> {
    let places = scattered(yours, 320);
    // Along edges, more rays a pixel give other colours; small pictures are all edges.
    let share = (0.12 + 24.0 / f64::from(yours.width())).min(0.4);
    let most = |count: usize| (share * count as f64) as usize;
    let rate = |cause: Cause| {
        let parts = cause.parts(yours.dimensions());
        misses(yours, &parts, &cause, &places[..48], ROUNDING, 6 + most(48))?;
        let misses = misses(yours, &parts, &cause, &places, ROUNDING, most(320))?;
        Some((misses, cause))
    };
    causes.into_iter().filter_map(rate).collect()
}

/// The causes, of the fewest mistakes, that explain every pixel; first those of
/// mistakes that belong to the step itself.
fn exact(yours: &RgbImage, causes: &[Rated]) -> Option<Found> {
    (0..=2).find_map(|count| {
        let level =
            causes.iter().filter(|(_, cause)| cause.mistakes.len() == count);
        let few = level.filter(|rated| rate(yours, rated, 512, 0, 0).is_some());
        let few = few.filter(|rated| rate(yours, rated, 20_000, 0, 0).is_some());
        let explains = |cause: &Cause| compare(yours, cause, 0).0 == 0;
        let causes = few.take(40).map(|(_, cause)| cause.clone());
        let mut causes: Vec<_> = causes.filter(explains).collect();
        causes.sort_by_key(|cause| {
            !cause.mistakes.iter().any(|m| m.step == cause.step)
        });
        (!causes.is_empty()).then_some(Found { causes, rest: 0 })
    })
}

/// The cause that explains all but a few pixels.
fn near(yours: &RgbImage, causes: &[Rated]) -> Option<Found> {
    let rated =
        |rated| Some((rate(yours, rated, 3000, ROUNDING, usize::MAX)?, rated));
    let mut causes: Vec<_> = causes.iter().take(60).filter_map(rated).collect();
    causes.sort_by_key(|(misses, (_, cause))| (*misses, cause.mistakes.len()));
    let best = causes.into_iter().take(4).map(|(_, (_, cause))| {
        let (rest, compared) = compare(yours, cause, ROUNDING);
        (rest, cause, compared)
    });
    // A second mistake has to explain much more than the first one alone.
    let (rest, cause, compared) = best
        .min_by_key(|(rest, cause, _)| (rest + 1) << (2 * cause.mistakes.len()))?;
    let right = Cause { mistakes: vec![], ..cause.clone() };
    let explained = match cause.mistakes.len() {
        0 => compared,
        _ => compare(yours, &right, ROUNDING).0,
    };
    (rest * 200 < compared && rest * 10 < explained)
        .then(|| Found { causes: vec![cause.clone()], rest })
}

/// At how many of about `count` rays' pixels the picture differs, or None where it is
/// more than `most`.
fn rate(
    yours: &RgbImage,
    (_, cause): &Rated,
    count: u32,
    rounding: u8,
    most: usize,
) -> Option<usize> {
    let places = scattered(yours, (count / cause.samples.pow(2)).max(48));
    let parts = cause.parts(yours.dimensions());
    misses(yours, &parts, cause, &places, rounding, most)
}

/// The likeliest of the causes, which come in this order, with the number of rays a
/// pixel that explains most.
fn with_more_rays(yours: &RgbImage, causes: &[Rated]) -> Vec<Rated> {
    let samples = samples(yours, causes);
    let more =
        |(misses, cause): &Rated| (*misses, Cause { samples, ..cause.clone() });
    causes.iter().take(160).map(more).collect()
}

/// The samples that explain best what the likeliest cause leaves unexplained.
fn samples(yours: &RgbImage, causes: &[Rated]) -> u32 {
    let Some((_, cause)) = causes.first() else { return 1 };
    let parts = cause.parts(yours.dimensions());
    let miss = |&(i, j): &(u32, u32)| {
        let ours = parts.pixel(cause.step, 1, i, j);
        (apart(yours.get_pixel(i, j), &ours), (i, j))
    };
    let mut edges: Vec<_> = scattered(yours, 20_000).iter().map(miss).collect();
    edges.sort_by_key(|&(apart, _)| Reverse(apart));
    let edges = edges.into_iter().filter(|&(apart, _)| 0 < apart);
    let edges: Vec<_> = edges.map(|(_, place)| place).take(120).collect();
    // The right number explains nearly all; where none does, one ray is the best guess.
    let explains = |samples: &u32| {
        let cause = Cause { samples: *samples, ..cause.clone() };
        misses(yours, &parts, &cause, &edges, 0, edges.len() / 3).is_some()
    };
    (2..=16).find(explains).unwrap_or(1)
}

/// How many pixels of all differ from what `cause` gives by more than `rounding`, and
/// how many were compared.
fn compare(yours: &RgbImage, cause: &Cause, rounding: u8) -> (usize, usize) {
    let (width, height) = yours.dimensions();
    let pixels = u64::from(width) * u64::from(height);
    let rays = pixels * u64::from(cause.samples * cause.samples);
    let stride = rays.div_ceil(RAYS).isqrt().max(1) as u32;
    let (columns, rows) = (width.div_ceil(stride), height.div_ceil(stride));
    let parts = cause.parts((width, height));
    let ours = RgbImage::from_par_fn(columns, rows, |i, j| {
        parts.pixel(cause.step, cause.samples, i * stride, j * stride)
    });
    let differ = ours.enumerate_pixels().filter(|(i, j, ours)| {
        rounding < apart(yours.get_pixel(i * stride, j * stride), ours)
    });
    (differ.count(), ours.pixels().len())
}

/// At how many of `places` the picture differs, or None where it is more than `most`.
fn misses(
    yours: &RgbImage,
    parts: &Parts,
    cause: &Cause,
    places: &[(u32, u32)],
    rounding: u8,
    most: usize,
) -> Option<usize> {
    let mut misses = 0;
    for &(i, j) in places {
        let ours = parts.pixel(cause.step, cause.samples, i, j);
        if rounding < apart(yours.get_pixel(i, j), &ours) {
            misses += 1;
        }
        if most < misses {
            return None;
        }
    }
    Some(misses)
}

/// Places that lie evenly over the picture, whatever their number.
pub(crate) fn scattered(picture: &RgbImage, count: u32) -> Vec<(u32, u32)> {
    let (width, height) = picture.dimensions();
    // Roberts' sequence: multiples of these two numbers fill the square evenly.
    let at = |k: u32, step: f64, size: u32| {
        (((f64::from(k) + 0.5) * step).fract() * f64::from(size)) as u32
    };
    (0..count)
        .map(|k| {
            (
                at(k, 0.754_877_666_246_693, width),
                at(k, 0.569_840_290_998_053, height),
            )
        })
        .collect()
}
