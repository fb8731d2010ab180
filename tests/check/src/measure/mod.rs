//! What a picture tells of the program that drew it, stage after stage.

use crate::formula::{Cause, Pixel, Riddle, Tree, kept, misses};
use crate::fov::is_option;
use crate::view::View;
use crate::{Options, Section, Step};
use image::RgbImage;
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;

mod least;
mod sky;
mod words;

mod black;
mod camera;
mod classes;
mod pixel;
mod reading;
mod shown;
mod table;
mod view;

use black::Black;
use least::Least;
pub(crate) use pixel::pixel;
use sky::Sky;
pub(crate) use table::of_mistakes;
pub(crate) use words::{number, vector};

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
    stages_beside(yours, step, None).0
}

/// The same, where our picture with the defaults is there already; and the options, where
/// all pixels are explained.
pub(crate) fn stages_beside(
    yours: &RgbImage,
    step: Step,
    ours: Option<&RgbImage>,
) -> (Vec<Stage>, Options) {
    if yours.width() < 2 {
        return (vec![], Options::NONE);
    }
    let black = Black::of(yours);
    let places = view::places(yours, black.as_ref());
    let all = explained(yours, step, &places, ours, true);
    let (mut stages, options) = all
        .unwrap_or_else(|| (reading::stages(yours, step, &places), Options::NONE));
    if let Some(black) = black {
        table::add_black(&mut stages, &black);
    }
    (stages, options)
}

/// The same, where one thing done otherwise explains every pixel.
pub(crate) fn by_one(
    yours: &RgbImage,
    step: Step,
    ours: &RgbImage,
) -> Option<(Vec<Stage>, Options)> {
    explained(yours, step, &view::places(yours, None), Some(ours), false)
}

/// The stages and the options, where one thing done otherwise explains every pixel; or
/// two, if they may.
fn explained(
    yours: &RgbImage,
    step: Step,
    places: &[(u32, u32)],
    ours: Option<&RgbImage>,
    may_be_two: bool,
) -> Option<(Vec<Stage>, Options)> {
    let views = view::likely(yours, step);
    let work = Arc::default();
    let riddle = |view: &Options, ask: Ask| {
        let (tree, groups) = asked(yours, step, places, view, ours, &work, ask)?;
        Some((table::explained(view, &tree, yours, &groups), *view))
    };
    let whole = View::whole(yours.clone());
    let is_alone = views.len() == 1;
    let rated = |view: &Options| {
        let is_given = is_alone || is_option(&whole, view.fov);
        // A little nearer is so by chance.
        let off = if is_alone { 0 } else { view.misses(step, yours) / 200 };
        (*view, off, is_given)
    };
    let rated: Vec<_> = views.iter().map(rated).collect();
    let given = rated.iter().filter(|(.., is_given)| *is_given);
    let (nearest, least, _) = given.min_by_key(|(_, off, _)| *off)?;
    let one = |(k, (view, off, is_given)): (usize, &(Options, usize, bool))| {
        // What is far-fetched is looked for with the options that are nearest alone; the
        // second number of samples is less likely, and takes longer.
        let is_first = k == 0 || views[k - 1].fov != view.fov;
        let is_likely = *is_given && (is_first || view.samples == 1);
        let is_thorough = may_be_two && is_likely && off == least;
        // One thing explains no picture that is much nearer to other options.
        let is_near = *off < least + 4;
        let ask = |riddle: Riddle, tree: &Tree| riddle.explained(tree, is_thorough);
        if is_near { riddle(view, &ask) } else { None }
    };
    let found = rated.iter().enumerate().find_map(one);
    let two = || riddle(nearest, &|riddle, tree| riddle.pair(tree));
    if may_be_two { found.or_else(two) } else { found }
}

/// Likely formulas that give a picture with these options, as a known mistake does.
pub(crate) fn alternatives(
    yours: &RgbImage,
    step: Step,
    options: &Options,
    ours: &RgbImage,
) -> Vec<Cause> {
    let places = view::places(yours, None);
    let places: Vec<_> = places.into_iter().step_by(5).collect();
    let ask = |riddle: Riddle, tree: &Tree| riddle.explained(tree, false);
    let work = Arc::default();
    let found = asked(yours, step, &places, options, Some(ours), &work, &ask);
    let mut all = found.map_or(vec![], |(_, groups)| groups.concat());
    all.retain(|cause| cause.rank < 2);
    all
}

/// Of two things done otherwise, for each of which there are several formulas, those that
/// explain a picture with one of the others.
pub(crate) fn together(
    yours: &RgbImage,
    step: Step,
    &Options { fov, samples }: &Options,
    [mut firsts, mut seconds]: [Vec<Cause>; 2],
) -> [Vec<Cause>; 2] {
    let tree = Tree::new(step, yours.dimensions(), fov, samples);
    let places = view::places(yours, None);
    let few = places.len() * samples.pow(2) as usize / 24_000 + 1;
    let few: Vec<_> = places.into_iter().step_by(few).collect();
    let fits = |one: &Cause, two: &Cause| {
        let tree = tree.with(&one.changes).with(&two.changes);
        misses(&tree, yours, samples, &few, 0).is_empty()
    };
    let both = firsts.clone();
    firsts.retain(|one| seconds.iter().any(|two| fits(one, two)));
    seconds.retain(|two| both.iter().any(|one| fits(one, two)));
    [firsts, seconds]
}

/// Asks what explains a picture with these options; `ours` is our picture without any.
fn asked(
    yours: &RgbImage,
    step: Step,
    places: &[(u32, u32)],
    options: &Options,
    ours: Option<&RgbImage>,
    work: &Arc<AtomicUsize>,
    ask: Ask,
) -> Option<(Tree, Groups)> {
    let (size, samples) = (yours.dimensions(), options.samples);
    let is_it =
        |ours: &&RgbImage| *options == Options::NONE && ours.dimensions() == size;
    let ours = ours.filter(is_it);
    let cause = options.cause(step);
    let parts = cause.parts(size);
    let pixel = |(i, j): (u32, u32)| match ours {
        Some(ours) => *ours.get_pixel(i, j),
        None => parts.pixel(step, samples, i, j),
    };
    let mut tree = Tree::new(step, size, options.fov, samples);
    tree.work = work.clone();
    // Spread by the golden ratio.
    let share = u32::MAX / options.one_of(yours);
    let mut at = 0_u32;
    let places = kept(places, &mut |_| {
        at = at.wrapping_add(0x9e37_79b9);
        at <= share
    });
    let riddle = Riddle { yours, samples, places: &places, ours: &pixel };
    let groups = ask(riddle, &tree)?;
    Some((tree, groups))
}

/// Those of some pixels that are of the sky of a picture, whatever rays it is of.
pub(crate) fn sky(yours: &RgbImage, places: &[Pixel]) -> Vec<Pixel> {
    let sky = Sky::of(yours).filter(|sky| !sky.is_even());
    let Some(sky) = sky else { return vec![] };
    let is_it = |off: f64| off < 1.0;
    kept(places, &mut |place| sky.off(yours, place).is_some_and(is_it))
}

/// A question to a picture.
type Ask<'a> = &'a dyn Fn(Riddle, &Tree) -> Option<Groups>;

/// Things done otherwise, in groups of which one explains as much as another.
type Groups = Vec<Vec<Cause>>;
