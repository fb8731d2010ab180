//! The gallery: in each file the mistakes of one stage, each a few lines that do one
//! thing wrong.

use crate::{Mistake, Step};

mod angle;
mod bytes;
mod intersect;
mod light;
mod matrix;
mod nearest;
mod phong;
mod ray;
mod shade;

/// The mistakes of each stage, in the order of the steps' files.
const STAGES: [&[Mistake]; 9] = [
    angle::ALL,
    matrix::ALL,
    ray::ALL,
    bytes::ALL,
    intersect::ALL,
    nearest::ALL,
    light::ALL,
    shade::ALL,
    phong::ALL,
];

/// How many mistakes there are.
pub const COUNT: usize = {
    let (mut count, mut stage) = (0, 0);
    while stage < STAGES.len() {
        count += STAGES[stage].len();
        stage += 1;
    }
    count
};

/// Every mistake of the gallery.
///
/// Where two are made at once, the earlier comes first: angles before mirror images.
pub fn mistakes() -> impl Iterator<Item = &'static Mistake> {
    STAGES.into_iter().flatten()
}

/// Every mistake, by the step in whose picture it is told.
pub fn by_step() -> impl Iterator<Item = &'static Mistake> {
    let of = |step| mistakes().filter(move |mistake| mistake.step == step);
    Step::ALL.into_iter().flat_map(of)
}
