use crate::difference::apart;
use crate::{Cause, Mistake, Step};
use image::{Rgb, RgbImage};
use std::cmp::Reverse;
use std::collections::HashSet;

/// What is known of a picture.
#[derive(Clone, Debug)]
pub struct Found {
    /// Whose picture it is, that of a step or of an exercise.
    pub name: String,
    /// The side of the grid of rays in each pixel.
    pub samples: u32,
    /// What went wrong; several lists, where several give the same picture. Where only
    /// the size or the samples are wrong, the list is empty.
    pub causes: Vec<Vec<&'static Mistake>>,
    /// What they leave unexplained.
    pub rest: Rest,
}

/// How far each pixel of a picture is from that of another.
#[derive(Clone, Debug)]
pub struct Rest {
    /// How far apart they are in the channel that differs most.
    pub apart: Vec<u8>,
    /// How many pixels there are; not all are compared where that takes very many rays.
    pub all: usize,
}

impl Rest {
    /// Whether the pictures are known to be equal in every pixel.
    pub fn is_none(&self) -> bool {
        self.beyond(0) == 0 && self.apart.len() == self.all
    }

    /// How many pixels are farther apart than by `rounding`.
    pub fn beyond(&self, rounding: u8) -> usize {
        self.apart.iter().filter(|&&apart| rounding < apart).count()
    }

    /// Whether these are few.
    pub fn is_few(&self, rounding: u8) -> bool {
        self.beyond(rounding) * FEW < self.apart.len()
    }
}

/// About how many rays are cast at most to compare a picture with one cause.
pub(crate) const RAYS: u64 = 16_000_000;

/// A channel that is off by this much may be so by rounding.
pub(crate) const ROUNDING: u8 = 2;

/// One in so many pixels is few.
const FEW: usize = 200;

/// Finds out how a picture came about in one of `steps`, or None where that is unknown.
///
/// Few pixels sort out nearly all causes; all pixels decide. The fewest mistakes win.
/// A cause that leaves pixels unexplained is found only where these are few: less than
/// one in 200, and than a tenth of those that it explains; or where rounding explains
/// them. A picture of one colour tells too little for two mistakes, or for rounding.
pub fn recognise(yours: &RgbImage, steps: &[Step]) -> Option<Found> {
    if yours.width() < 2 {
        return None;
    }
    let (most, roundings): (_, &[u8]) = match flat(yours) {
        Some(_) => (1, &[0]),
        None => (2, &[0, ROUNDING]),
    };
    let mut likely = vec![];
    for count in 0..=most {
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
    let more = with_more_rays(yours, &likely);
    let near = |&rounding| near(yours, &likely, &more, rounding);
    exact(yours, &more).or_else(|| roundings.iter().find_map(near))
}

/// The colour of a picture that has one colour only, but for a few pixels.
pub(crate) fn flat(picture: &RgbImage) -> Option<Rgb<u8>> {
    let colour = |(i, j)| *picture.get_pixel(i, j);
    let is_all = |colour: &Rgb<u8>| {
        let others = picture.pixels().filter(|pixel| *pixel != colour).count();
        others * FEW < picture.pixels().len()
    };
    scattered(picture, 3).into_iter().map(colour).find(is_all)
}

type Rated = (usize, Cause);

/// The causes that explain most of a few hundred pixels, and of the first few of them.
fn sieved(yours: &RgbImage, causes: Vec<Cause>) -> Vec<Rated> {
    let places = scattered(yours, 320);
    // Along edges, more rays a pixel give other colours; small pictures are all edges.
    let share = (0.12 + 24.0 / f64::from(yours.width())).min(0.4);
    let most = |count: usize| (share * count as f64) as usize;
    let rate = |cause: Cause| {
        misses(yours, &cause, &places[..48], ROUNDING, 6 + most(48))?;
        let misses = misses(yours, &cause, &places, ROUNDING, most(320))?;
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
        let rest = |(_, cause): &Rated| (cause.clone(), compare(yours, cause));
        let mut all: Vec<_> =
            few.map(rest).filter(|(_, rest)| rest.beyond(0) == 0).collect();
        all.sort_by_key(|(cause, _)| {
            !cause.mistakes.iter().any(|m| m.step == cause.step)
        });
        found(all)
    })
}

/// The causes and what they leave over, by the first of them: each once, although
/// several steps may know it.
fn found(causes: Vec<(Cause, Rest)>) -> Option<Found> {
    let (Cause { step, samples, .. }, rest) = causes.first()?.clone();
    let mut told = HashSet::new();
    let names = |mistakes: &[&Mistake]| -> Vec<_> {
        mistakes.iter().map(|mistake| mistake.name).collect()
    };
    let causes = causes.into_iter().map(|(cause, _)| cause.mistakes);
    let causes = causes.filter(|mistakes| told.insert(names(mistakes))).collect();
    Some(Found { name: step.name().to_owned(), samples, causes, rest })
}

/// The cause that explains all but a few pixels, or all but the rounding.
fn near(
    yours: &RgbImage,
    likely: &[Rated],
    more: &[Rated],
    rounding: u8,
) -> Option<Found> {
    let rated =
        |rated| Some((rate(yours, rated, 3000, rounding, usize::MAX)?, rated));
    let all = likely.iter().take(60).chain(more.iter().take(60));
    let mut causes: Vec<_> = all.filter_map(rated).collect();
    causes.sort_by_key(|(misses, (_, cause))| (*misses, cause.mistakes.len()));
    let best = causes.into_iter().take(4);
    let best = best.map(|(_, (_, cause))| (cause, compare(yours, cause)));
    // A second mistake has to explain much more than the first one alone.
    let (cause, rest) = best.min_by_key(|(cause, rest)| {
        (rest.beyond(rounding) + 1) << (2 * cause.mistakes.len())
    })?;
    let right = Cause { mistakes: vec![], ..cause.clone() };
    let explained = match cause.mistakes.len() {
        0 => rest.apart.len(),
        _ => compare(yours, &right).beyond(rounding),
    };
    let is_near = rest.is_few(rounding) && rest.beyond(rounding) * 10 < explained;
    is_near.then(|| found(vec![(cause.clone(), rest)]))?
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
    misses(yours, cause, &places, rounding, most)
}

/// The likeliest of the causes, which come in this order, with the number of rays a
/// pixel that explains most; none where that is one, or can't be told.
fn with_more_rays(yours: &RgbImage, causes: &[Rated]) -> Vec<Rated> {
    let samples = samples(yours, causes).filter(|_| flat(yours).is_none());
    let Some(samples) = samples else { return vec![] };
    let more =
        |(misses, cause): &Rated| (*misses, Cause { samples, ..cause.clone() });
    causes.iter().take(160).map(more).collect()
}

/// The samples, more than 1, that explain what the likeliest cause leaves unexplained.
fn samples(yours: &RgbImage, causes: &[Rated]) -> Option<u32> {
    let (_, cause) = causes.first()?;
    let parts = cause.parts(yours.dimensions());
    let miss = |&(i, j): &(u32, u32)| {
        let ours = parts.pixel(cause.step, 1, i, j);
        (apart(yours.get_pixel(i, j), &ours), (i, j))
    };
    let mut edges: Vec<_> = scattered(yours, 20_000).iter().map(miss).collect();
    edges.sort_by_key(|&(apart, _)| Reverse(apart));
    let edges = edges.into_iter().filter(|&(apart, _)| 0 < apart);
    let edges: Vec<_> = edges.map(|(_, place)| place).take(120).collect();
    // The right number explains nearly all, if there is anything to explain.
    let explains = |samples: &u32| {
        let cause = Cause { samples: *samples, ..cause.clone() };
        misses(yours, &cause, &edges, 0, edges.len() / 3).is_some()
    };
    (2..=16).find(explains).filter(|_| !edges.is_empty())
}

/// What `cause` leaves unexplained.
fn compare(yours: &RgbImage, cause: &Cause) -> Rest {
    let (width, height) = yours.dimensions();
    let all = yours.pixels().len();
    let rays = all as u64 * u64::from(cause.samples.pow(2));
    let stride = (rays.div_ceil(RAYS) - 1).isqrt() as u32 + 1;
    let (columns, rows) = (width.div_ceil(stride), height.div_ceil(stride));
    let parts = cause.parts((width, height));
    let ours = RgbImage::from_par_fn(columns, rows, |i, j| {
        parts.pixel(cause.step, cause.samples, i * stride, j * stride)
    });
    let pairs = ours
        .enumerate_pixels()
        .map(|(i, j, ours)| apart(yours.get_pixel(i * stride, j * stride), ours));
    Rest { apart: pairs.collect(), all }
}

/// At how many of `places` the picture differs, or None where it is more than `most`.
fn misses(
    yours: &RgbImage,
    cause: &Cause,
    places: &[(u32, u32)],
    rounding: u8,
    most: usize,
) -> Option<usize> {
    let parts = cause.parts(yours.dimensions());
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
