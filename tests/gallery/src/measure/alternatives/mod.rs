//! Parts of the program that may be others than ours, each with one thing done wrong:
//! those of the gallery, and those that need no picture of their own.

use crate::{Parts, Section, mistakes};
use glam::DVec3;
use step01_rays::Ray;

mod diffuse;
mod fades;
mod points;
mod rays;
mod roots;
mod specular;
mod sums;

/// A part of the program that may be another than ours.
#[derive(Clone, Copy, Debug)]
pub(super) struct Alternative {
    /// Where it belongs.
    pub section: Section,
    /// What is wrong, to be read after "it is what you get when".
    pub when: &'static str,
    /// Replaces a part.
    pub change: fn(&mut Parts),
    /// Changes the vectors from which l and d are taken, those of the diffuse term, and
    /// those of the specular term.
    pub vectors: [fn(&mut Vectors); 3],
    /// Changes the five parts of the sum.
    pub sum: fn(&mut [DVec3; 5], DVec3),
}

/// All that the light at a point is made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors {
    pub ray: Ray,
    pub p: DVec3,
    pub n: DVec3,
    pub v: DVec3,
    pub l: DVec3,
    pub d: f64,
    pub r: DVec3,
}

/// One that replaces a part.
const fn part(
    section: Section,
    when: &'static str,
    change: fn(&mut Parts),
) -> Alternative {
    Alternative { section, when, change, vectors: [|_| {}; 3], sum: |_, _| {} }
}

/// One that changes the vectors before the light is seen (0), before the diffuse term
/// (1) or before the specular term (2).
const fn vectors(
    section: Section,
    when: &'static str,
    which: usize,
    change: fn(&mut Vectors),
) -> Alternative {
    let mut one = part(section, when, |_| {});
    one.vectors[which] = change;
    one
}

/// One that changes the five parts of the sum, with L_a at hand.
const fn sum(
    section: Section,
    when: &'static str,
    sum: fn(&mut [DVec3; 5], DVec3),
) -> Alternative {
    Alternative { sum, ..part(section, when, |_| {}) }
}

/// All that are tried.
pub(super) fn alternatives() -> impl Iterator<Item = Alternative> {
    let others = [
        rays::ALL,
        roots::ALL,
        points::ALL,
        diffuse::ALL,
        fades::ALL,
        specular::ALL,
        sums::ALL,
    ];
    // The weights of the lights tell which of them are left out.
    let is_told =
        |name: &str| ["first-light-only", "last-light-only"].contains(&name);
    let known = mistakes().filter(move |m| !is_told(m.name));
    let known = known.map(|m| part(m.section, m.when, m.change));
    known.chain(others.into_iter().flatten().copied())
}
