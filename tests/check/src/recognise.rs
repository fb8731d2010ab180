use crate::apart;
use crate::fov::{FOV, fields_of_view};
use crate::view::View;
use crate::{Cause, Mistake, Options, Rest, Step, at_once, each, sort};

/// What is known of a picture.
#[derive(Clone, Debug)]
pub struct Found {
    /// Whose picture it is, that of a step or of an exercise.
    pub name: String,
    /// The side of the grid of rays in each pixel.
    pub samples: u32,
    /// The field of view θ, in degrees.
    pub fov: f64,
    /// What went wrong; several lists, where several give the same picture. Where only
    /// the size or the samples are wrong, the list is empty.
    pub causes: Vec<Vec<&'static Mistake>>,
    /// A field of view that explains it as well, without any mistake.
    pub same_fov: Option<f64>,
    /// What they leave unexplained.
    pub rest: Rest,
}

impl Found {
    /// The first cause, in the picture of `step`.
    pub fn cause(&self, step: Step) -> Cause {
        let Self { samples, fov, .. } = *self;
        Cause { step, samples, fov, mistakes: self.causes[0].clone() }
    }

    /// The options that it explains.
    pub fn options(&self) -> Options {
        let Self { samples, fov, .. } = *self;
        Options { fov, samples }
    }
}

/// About how many rays are cast at most to compare a picture with one cause.
const RAYS: u64 = 16_000_000;

/// A channel that is off by this much may be so by rounding.
pub(crate) const ROUNDING: u8 = 2;

/// Finds out how a picture came about in one of `steps`, or None where that is unknown.
///
/// Few pixels sort out nearly all causes; all pixels decide. The fewest mistakes win.
/// One mistake that leaves pixels unexplained is found only where these are few: less
/// than one in 1000, and than a tenth of those that it explains. Two mistakes must
/// explain every pixel. Only of the right picture it is said that it may be rounded.
pub fn recognise(yours: &View, steps: &[Step]) -> Option<Found> {
    if yours.size.0 < 2 {
        return None;
    }
    let is_flat = yours.flat().is_some();
    let mut likely = vec![];
    let most = if is_flat { 1 } else { 2 };
    let found = levels(yours, steps, most, FOV, &mut likely);
    let fields = if is_flat { vec![] } else { fields_of_view(yours) };
    let optional = |steps: &[Step], most: usize| {
        let mut fields = fields.iter();
        fields.find_map(|fov| levels(yours, steps, most, *fov, &mut vec![]))
    };
    // Without an object, a mistake and an angle together explain too much.
    let has_objects = |step: &&Step| **step != Step::Rays;
    let later: Vec<_> = steps.iter().filter(has_objects).copied().collect();
    if let Some(found) = found {
        // An option and one mistake are likelier than two mistakes.
        if 1 < found.causes[0].len()
            && let Some(likelier) = optional(&later, 1)
        {
            return Some(likelier);
        }
        let is_right = found.causes[0].is_empty();
        let same = if is_right { None } else { optional(steps, 0) };
        return Some(Found { same_fov: same.map(|same| same.fov), ..found });
    }
    if let Some(found) = optional(steps, 0).or_else(|| optional(&later, 1)) {
        return Some(found);
    }
    sort(&mut likely, |(misses, cause)| [*misses, cause.mistakes.len()]);
    let more = with_more_rays(yours, &likely);
    likely.extend(more.iter().cloned());
    let found = exact(yours, &more).or_else(|| near(yours, &likely, 0));
    found.or_else(|| {
        likely.retain(|(_, cause)| cause.mistakes.is_empty() && !is_flat);
        near(yours, &likely, ROUNDING)
    })
}

/// The cause, of `most` mistakes or less, that explains every pixel; if there is none,
/// the likeliest are added to `likely`.
fn levels(
    yours: &View,
    steps: &[Step],
    most: usize,
    fov: f64,
    likely: &mut Vec<Rated>,
) -> Option<Found> {
    for count in 0..=most {
        let all = steps.iter().flat_map(|&step| Cause::all(step, count, fov));
        let mut level = sieved(yours, all.collect());
        sort(&mut level, |(misses, _)| [*misses, 0]);
        let more = || exact(yours, &with_more_rays(yours, &level));
        if let Some(found) = exact(yours, &level).or_else(more) {
            return Some(found);
        }
        likely.append(&mut level);
    }
    None
}

type Rated = (usize, Cause);

/// The causes that explain most of a few hundred pixels, and of the first few of them.
fn sieved(yours: &View, causes: Vec<Cause>) -> Vec<Rated> {
    let places = yours.scattered(320);
    // Along edges, more rays a pixel give other colours; small pictures are all edges.
    let share = (0.12 + 24.0 / f64::from(yours.size.0)).min(0.4);
    let most = |count: usize| (share * count as f64) as usize;
    let rate = |cause: Cause| {
        misses(yours, &cause, &places[..48], ROUNDING, 6 + most(48))?;
        let misses = misses(yours, &cause, &places, ROUNDING, most(320))?;
        Some((misses, cause))
    };
    each(causes, rate)
}

/// The causes, of the fewest mistakes, that explain every pixel; first those of
/// mistakes that belong to the step itself.
fn exact(yours: &View, causes: &[Rated]) -> Option<Found> {
    (0..=2).find_map(|count| {
        let level =
            causes.iter().filter(|(_, cause)| cause.mistakes.len() == count);
        let fits = |rated, count| rate(yours, rated, count, 0, 0).is_some();
        let few = level.filter(|rated| fits(rated, 512) && fits(rated, 20_000));
        // What one does not explain tells others, too.
        let mut telling = vec![];
        let rest = |(_, cause): &Rated| {
            misses(yours, cause, &telling, 0, 0)?;
            let rest = compare(yours, cause, 0, 0);
            telling.extend(rest.as_ref().err());
            Some((cause.clone(), rest.ok()?))
        };
        let mut all: Vec<_> = few.filter_map(rest).collect();
        sort(&mut all, |(cause, _)| {
            let is_its = cause.mistakes.iter().any(|m| m.step == cause.step);
            [usize::from(!is_its), 0]
        });
        found(all)
    })
}

/// The causes and what they leave over, by the first of them: each once, although
/// several steps may know it.
fn found(causes: Vec<(Cause, Rest)>) -> Option<Found> {
    let (Cause { step, samples, fov, .. }, rest) = causes.first()?.clone();
    let names = |mistakes: &[&Mistake]| -> Vec<_> {
        mistakes.iter().map(|mistake| mistake.name).collect()
    };
    let mut told: Vec<Vec<&Mistake>> = vec![];
    for (Cause { mistakes, .. }, _) in causes {
        if told.iter().all(|known| names(known) != names(&mistakes)) {
            told.push(mistakes);
        }
    }
    Some(Found {
        name: step.name().to_owned(),
        samples,
        fov,
        causes: told,
        same_fov: None,
        rest,
    })
}

/// The causes, of one mistake at most, that explain all but a few pixels, or all but
/// the rounding; two mistakes that do not explain every pixel would be a guess.
fn near(yours: &View, likely: &[Rated], rounding: u8) -> Option<Found> {
    // Few of all pixels are no more than three or four of these.
    let rated = |rated| Some((rate(yours, rated, 3000, rounding, 24)?, rated));
    let all = likely.iter().filter(|(_, cause)| cause.mistakes.len() <= 1);
    let mut causes: Vec<_> = all.filter_map(rated).collect();
    sort(&mut causes, |(misses, (_, cause))| [*misses, cause.mistakes.len()]);
    let compared = |(_, (_, cause)): (usize, &Rated)| {
        let rest = compare(yours, cause, rounding, Rest::few_of(yours.pixels()));
        Some((cause.clone(), rest.ok()?))
    };
    let mut best: Vec<_> =
        causes.into_iter().take(4).filter_map(compared).collect();
    let cost = |(cause, rest): &(Cause, Rest)| {
        (rest.beyond(rounding) + 1) << (2 * cause.mistakes.len())
    };
    sort(&mut best, |one| [cost(one), 0]);
    let least = cost(best.first()?);
    best.retain(|one| cost(one) == least);
    let (cause, rest) = best.first()?;
    let right = Cause { mistakes: vec![], ..cause.clone() };
    let ten_times = 10 * rest.beyond(rounding);
    let explains = match cause.mistakes.len() {
        0 => ten_times < rest.compared(),
        _ => compare(yours, &right, rounding, ten_times).is_err(),
    };
    let is_near = explains && rest.is_few(rounding);
    is_near.then(|| found(best))?
}

/// At how many of about `count` rays' pixels the picture differs, or None where it is
/// more than `most`.
fn rate(
    yours: &View,
    (_, cause): &Rated,
    count: u32,
    rounding: u8,
    most: usize,
) -> Option<usize> {
    let places = yours.scattered((count / cause.samples.pow(2)).max(48));
    misses(yours, cause, &places, rounding, most)
}

/// The likeliest of the causes, which come in this order, with the number of rays a
/// pixel that explains most; none where that is one, or can't be told.
fn with_more_rays(yours: &View, causes: &[Rated]) -> Vec<Rated> {
    let samples = samples(yours, causes).filter(|_| yours.flat().is_none());
    let Some(samples) = samples else { return vec![] };
    let more =
        |(misses, cause): &Rated| (*misses, Cause { samples, ..cause.clone() });
    causes.iter().take(160).map(more).collect()
}

/// The samples, more than 1, that explain what the likeliest cause leaves unexplained.
fn samples(yours: &View, causes: &[Rated]) -> Option<u32> {
    let (_, cause) = causes.first()?;
    let parts = cause.parts(yours.size);
    let miss = |&(i, j): &(u32, u32)| {
        let ours = parts.pixel(cause.step, 1, i, j);
        (apart(yours.pixel(i, j), &ours), (i, j))
    };
    let mut edges: Vec<_> = yours.scattered(20_000).iter().map(miss).collect();
    sort(&mut edges, |&(apart, _)| [usize::from(u8::MAX - apart), 0]);
    let edges = edges.into_iter().filter(|&(apart, _)| 0 < apart);
    let edges: Vec<_> = edges.map(|(_, place)| place).take(120).collect();
    // The right number explains nearly all, if there is anything to explain; another one
    // hardly any, which a few tell.
    let few: Vec<_> = edges.iter().step_by(13).copied().collect();
    let explains = |samples: &u32| {
        let cause = Cause { samples: *samples, ..cause.clone() };
        let all = [(&few, few.len() * 2 / 3), (&edges, edges.len() / 3)];
        all.iter()
            .all(|(edges, most)| misses(yours, &cause, edges, 0, *most).is_some())
    };
    (2..=16).find(explains).filter(|_| !edges.is_empty())
}

/// What `cause` leaves unexplained; or, where more than `most` pixels are off by more than
/// `rounding`, the first of those that are too many.
fn compare(
    yours: &View,
    cause: &Cause,
    rounding: u8,
    most: usize,
) -> Result<Rest, (u32, u32)> {
    let ((width, height), all) = (yours.size, yours.pixels());
    let rays = all as u64 * u64::from(cause.samples.pow(2));
    let stride = (rays.div_ceil(RAYS) - 1).isqrt() as u32 + 1;
    let stride = stride.next_multiple_of(yours.stride) as usize;
    let parts = cause.parts((width, height));
    let (mut rest, mut beyond) = (Rest::new(all), 0);
    let rows: Vec<_> = (0..height).step_by(stride).collect();
    let row = |j: u32| {
        let columns = (0..width).step_by(stride);
        let one = |i: u32| {
            let ours = parts.pixel(cause.step, cause.samples, i, j);
            (i, j, apart(yours.pixel(i, j), &ours))
        };
        Some(columns.map(one).collect::<Vec<_>>())
    };
    for rows in rows.chunks(4 * at_once()) {
        for row in each(rows.to_vec(), row) {
            for (i, j, apart) in row {
                rest.add(apart);
                beyond += usize::from(rounding < apart);
                if most < beyond {
                    return Err((i, j));
                }
            }
        }
    }
    Ok(rest)
}

/// At how many of `places` the picture differs, or None where it is more than `most`.
fn misses(
    yours: &View,
    cause: &Cause,
    places: &[(u32, u32)],
    rounding: u8,
    most: usize,
) -> Option<usize> {
    let parts = cause.parts(yours.size);
    let mut misses = 0;
    for &(i, j) in places {
        let ours = parts.pixel(cause.step, cause.samples, i, j);
        if rounding < apart(yours.pixel(i, j), &ours) {
            misses += 1;
        }
        if most < misses {
            return None;
        }
    }
    Some(misses)
}
