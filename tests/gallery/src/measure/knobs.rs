use super::look::hit;
use super::words::{number, vector};
use super::{Look, Place};
use crate::section::{self, Section};
use crate::{Parts, Step};
use glam::DVec3;

/// A number of the scene that may be another than ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Knob {
    /// x, y or z (0 to 2) of the centre of an object.
    Centre(usize, usize),
    /// The radius of an object.
    Radius(usize),
    /// x, y or z of the position of a light.
    Position(usize, usize),
    /// a, b or c (0 to 2) of a light.
    Fade(usize, usize),
}

/// A number that explains more than ours.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turned {
    pub knob: Knob,
    pub value: f64,
    /// How far off the picture is with it.
    pub cost: u32,
}

impl Knob {
    /// Where the number stands in the parts.
    pub fn of<'a>(&self, parts: &'a mut Parts, step: Step) -> &'a mut f64 {
        let lights = &mut parts.scene.lights;
        match *self {
            Self::Centre(k, axis) => {
                &mut sphere(&mut parts.sphere, &mut parts.scene.objects, step, k)
                    .centre[axis]
            }
            Self::Radius(k) => {
                &mut sphere(&mut parts.sphere, &mut parts.scene.objects, step, k)
                    .radius
            }
            Self::Position(k, axis) => &mut lights[k].point.position[axis],
            Self::Fade(k, 0) => &mut lights[k].point.attenuation.a,
            Self::Fade(k, 1) => &mut lights[k].point.attenuation.b,
            Self::Fade(k, _) => &mut lights[k].point.attenuation.c,
        }
    }

    /// What is told of a number, theirs and ours.
    pub fn told(&self, theirs: &Parts, ours: &Parts, step: Step) -> String {
        let (mut theirs, mut ours) = (theirs.clone(), ours.clone());
        let light = |k: usize| ["warm", "cool"][k];
        let [yours_is, ours_is] =
            [&mut theirs, &mut ours].map(|p| *self.of(p, step));
        match *self {
            Self::Centre(k, _) => {
                let [a, b] =
                    [&theirs, &ours].map(|p| p.objects(step)[k].sphere.centre);
                let name = ours.objects(step)[k].material.name;
                format!(
                    "{name} is at {} in your picture; it should be at {}",
                    vector(a),
                    vector(b)
                )
            }
            Self::Radius(k) => {
                let name = ours.objects(step)[k].material.name;
                format!(
                    "{name} has a radius of {} in your picture; it should be {}",
                    number(yours_is),
                    number(ours_is)
                )
            }
            Self::Position(k, _) => {
                let [a, b] =
                    [&theirs, &ours].map(|p| p.scene.lights[k].point.position);
                format!(
                    "the {} light is at {} in your picture; it should be at {}",
                    light(k),
                    vector(a),
                    vector(b)
                )
            }
            Self::Fade(k, part) => format!(
                "the {} light's {} in a + bd + cd² is {} in your picture; it should be {}",
                light(k),
                ["a", "b", "c"][part],
                number(yours_is),
                number(ours_is)
            ),
        }
    }

    /// Where the number stands in the book.
    pub fn section(&self, step: Step) -> Section {
        match self {
            Self::Centre(..) | Self::Radius(_) if step == Step::Sphere => {
                section::ONE_COLOUR
            }
            Self::Centre(..) | Self::Radius(_) => section::SCENE,
            Self::Position(..) | Self::Fade(..) => section::LAMPS,
        }
    }

    /// All those of some objects.
    pub fn shapes(objects: &[usize]) -> Vec<Self> {
        let of = |&k: &usize| {
            [
                Self::Centre(k, 0),
                Self::Centre(k, 1),
                Self::Centre(k, 2),
                Self::Radius(k),
            ]
        };
        objects.iter().flat_map(of).collect()
    }

    /// All those of the lights.
    pub fn lights() -> Vec<Self> {
        let three = |knob: fn(usize, usize) -> Self| {
            [0, 1].into_iter().flat_map(move |k| (0..3).map(move |n| knob(k, n)))
        };
        three(Self::Fade).chain(three(Self::Position)).collect()
    }
}

fn sphere<'a>(
    one: &'a mut step03_nearest::Object<crate::Named>,
    many: &'a mut [step03_nearest::Object<crate::Named>],
    step: Step,
    k: usize,
) -> &'a mut step02_sphere::Sphere {
    match step {
        Step::Sphere => &mut one.sphere,
        _ => &mut many[k].sphere,
    }
}

/// The one of some knobs that makes a picture most like the reader's, by far.
pub(super) fn turned(
    look: &Look,
    knobs: &[Knob],
    places: &[Place],
) -> Option<Turned> {
    let mut parts = look.theirs.clone();
    let before = cost(look, &parts, places);
    let all = knobs.iter().map(|&knob| turn(look, &mut parts, knob, places));
    all.min_by_key(|turned| turned.cost)
        .filter(|turned| 3 * turned.cost < 2 * before)
}

/// The value of a knob that explains most: first a few everywhere, then nearer ones.
fn turn(look: &Look, parts: &mut Parts, knob: Knob, places: &[Place]) -> Turned {
    let ours = *knob.of(parts, look.step);
    let mut rate = |value: f64| {
        *knob.of(parts, look.step) = value;
        (cost(look, parts, places), value)
    };
    let size = ours.abs().max(0.02);
    let natural = [-1.0, 0.0, 0.1, 10.0, 0.5, 2.0].map(|times| times * ours);
    let grid = (-12..=12).map(|k| match knob {
        Knob::Fade(..) => size * 1.25_f64.powi(k),
        _ => ours + 0.3 * f64::from(k),
    });
    let all: Vec<_> = natural.into_iter().chain(grid).collect();
    let mut best = (u32::MAX, ours);
    for value in all {
        let rated = rate(value);
        best = if rated.0 < best.0 { rated } else { best };
    }
    let mut step: f64 = match knob {
        Knob::Fade(..) => best.1.abs() / 8.0,
        _ => 0.15,
    };
    while size.min(1.0) * 0.002 < step && 0 < best.0 {
        for value in [best.1 - step, best.1 + step] {
            let rated = rate(value);
            best = if rated.0 < best.0 { rated } else { best };
        }
        step /= 1.6;
    }
    best = rounded(best, &mut rate);
    *knob.of(parts, look.step) = ours;
    Turned { knob, value: best.1, cost: best.0 }
}

/// The value with the fewest digits that is as good, or nearly.
fn rounded(
    best: (u32, f64),
    rate: &mut impl FnMut(f64) -> (u32, f64),
) -> (u32, f64) {
    for digits in 0..4 {
        let scale = 10_f64.powi(digits);
        let rated = rate((best.1 * scale).round() / scale);
        if rated.0 <= best.0 + best.0 / 8 {
            return rated;
        }
    }
    best
}

/// How far off a picture of some parts is, at some places.
pub(super) fn cost(look: &Look, parts: &Parts, places: &[Place]) -> u32 {
    let least = u8::from(look.is_loose());
    let apart = |p: &Place| {
        let sky = hit(parts, look.step, p.i.into(), p.j.into()).is_none();
        let ours = match sky {
            true => look.sky_pixel(parts, &look.tint, p.i, p.j),
            false => look.bytes.write(parts.intensity(look.step, p.i, p.j)),
        };
        let apart = crate::difference::apart(look.yours.get_pixel(p.i, p.j), &ours);
        u32::from(apart.min(24)) * u32::from(least < apart)
    };
    places.iter().map(apart).sum()
}

/// Places at which the parts that are known do not explain the picture, and others.
pub(super) fn telling(look: &Look, places: &[Place], count: usize) -> Vec<Place> {
    let few = places.iter().step_by(places.len() / 12_000 + 1);
    let is_wrong =
        |p: &&Place| 0 < cost(look, &look.theirs, std::slice::from_ref(p));
    let (wrong, right): (Vec<_>, Vec<_>) = few.partition(is_wrong);
    let thin = |all: &[&Place]| -> Vec<Place> {
        all.iter().step_by(all.len() / count + 1).map(|p| **p).collect()
    };
    [thin(&wrong), thin(&right)].concat()
}

/// The objects of which much is wrong, and those that should not be seen.
pub(super) fn suspects(look: &Look, places: &[Place]) -> Vec<usize> {
    let few: Vec<_> = places.iter().step_by(places.len() / 12_000 + 1).collect();
    let all = 0..look.theirs.objects(look.step).len();
    all.filter(|&k| {
        let its: Vec<_> = few.iter().filter(|p| p.hit == Some(k)).collect();
        let wrong = its
            .iter()
            .filter(|p| 0 < cost(look, &look.theirs, std::slice::from_ref(**p)));
        its.len() <= 12 * wrong.count()
    })
    .collect()
}

/// Sets a knob of some parts.
pub(super) fn set(parts: &mut Parts, turned: &Turned, step: Step) {
    *turned.knob.of(parts, step) = turned.value;
    let _ = DVec3::ZERO;
}
