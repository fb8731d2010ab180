use crate::difference::apart;
use crate::recognise::scattered;
use crate::{Parts, Step};
use image::{Rgb, RgbImage, imageops};
use std::fmt::Write;
use step01_rays::Camera;
use step02_sphere::SPHERE;
use step03_nearest::SPHERES;

/// What the spheres of steps 3 to 5 are called, and the sky.
const OBJECTS: [&str; 10] = [
    "the red sphere",
    "the ground",
    "the golden sphere",
    "the blue sphere",
    "the green sphere",
    "the teal sphere",
    "the white sphere",
    "the salmon sphere",
    "the small sphere in the air",
    "the sky",
];

/// What can be seen of the difference between two pictures of one size, in sentences,
/// each on a line.
pub(crate) fn seen(
    yours: &RgbImage,
    ours: &RgbImage,
    step: Option<Step>,
) -> String {
    let mut text = region(yours, ours);
    if let Some(turned) = turned(yours, ours) {
        let _ = writeln!(text, "It is much closer to ours {turned}.");
    } else if let Some(step) = step.filter(|&step| step != Step::Rays) {
        text += &objects(yours, ours, step);
    }
    text
}

/// How many pixels differ, how far and where.
pub(crate) fn region(yours: &RgbImage, ours: &RgbImage) -> String {
    let places: Vec<_> = yours
        .enumerate_pixels()
        .zip(ours.pixels())
        .map(|((i, j, yours), ours)| (i, j, apart(yours, ours)))
        .filter(|&(.., apart)| 0 < apart)
        .collect();
    let all = yours.pixels().len();
    let within = |values: Vec<u32>| {
        let least = values.iter().min().copied().unwrap_or(0);
        format!("{least} to {}", values.iter().max().copied().unwrap_or(0))
    };
    format!(
        "{} of {all} pixels differ, by up to {} of 255, in columns {} and rows {}.\n",
        places.len(),
        places.iter().map(|&(.., apart)| apart).max().unwrap_or(0),
        within(places.iter().map(|&(i, ..)| i).collect()),
        within(places.iter().map(|&(_, j, _)| j).collect()),
    )
}

/// On which objects the pictures differ, and which are right.
fn objects(yours: &RgbImage, ours: &RgbImage, step: Step) -> String {
    let (width, height) = ours.dimensions();
    let parts = Parts::right(&Camera::new(width, height, 60_f64.to_radians()));
    let mut found = [(0, 0, 0); OBJECTS.len()];
    for ((i, j, yours), ours) in yours.enumerate_pixels().zip(ours.pixels()) {
        let (all, wrong, lighter) = &mut found[object(&parts, step, i, j)];
        *all += 1;
        *wrong += i64::from(yours != ours);
        *lighter += sum(yours) - sum(ours);
    }
    let name = |index: usize| match step {
        Step::Sphere if index == 0 => "the sphere",
        _ => OBJECTS[index],
    };
    let (mut wrong, mut right) = (vec![], vec![]);
    for (index, (all, differ, lighter)) in found.into_iter().enumerate() {
        match (all, differ) {
            (0, _) => {}
            (_, 0) => right.push(name(index).to_owned()),
            _ => wrong.push(format!(
                "{} ({}{})",
                name(index),
                percent(differ, all),
                shade(lighter / (3 * differ))
            )),
        }
    }
    let mut text = format!("It differs on {}.\n", wrong.join(", "));
    if !right.is_empty() {
        let _ = writeln!(text, "Right in every pixel: {}.", right.join(", "));
    }
    text
}

fn object(parts: &Parts, step: Step, i: u32, j: u32) -> usize {
    let ray = parts.camera.ray(i.into(), j.into());
    let index = match step {
        Step::Sphere => (parts.first_hit)(&SPHERE, &ray).map(|_| 0),
        _ => (parts.nearest)(&SPHERES, &ray, parts.first_hit).map(|hit| hit.index),
    };
    index.unwrap_or(OBJECTS.len() - 1)
}

fn sum(colour: &Rgb<u8>) -> i64 {
    colour.0.iter().map(|&channel| i64::from(channel)).sum()
}

fn percent(part: i64, all: i64) -> String {
    match 100 * part / all {
        0 => "less than 1 % of it".to_owned(),
        100 => "all of it".to_owned(),
        share => format!("{share} % of it"),
    }
}

/// How much brighter, on average, if that can be seen.
fn shade(lighter: i64) -> String {
    match lighter {
        ..-4 => format!(", darker by {} of 255", -lighter),
        5.. => format!(", brighter by {lighter} of 255"),
        _ => String::new(),
    }
}

/// How your picture has to be turned or moved to be at least twice as close to ours.
fn turned(yours: &RgbImage, ours: &RgbImage) -> Option<String> {
    let places = scattered(ours, 4000);
    let wrong = |yours: &RgbImage, (x, y): (i64, i64)| {
        let differs = |&(i, j): &(u32, u32)| {
            let at = |k: u32, d: i64, size: u32| {
                (i64::from(k) + d).clamp(0, i64::from(size) - 1) as u32
            };
            let (width, height) = yours.dimensions();
            let yours = yours.get_pixel(at(i, x, width), at(j, y, height));
            8 < apart(yours, ours.get_pixel(i, j))
        };
        places.iter().filter(|place| differs(place)).count()
    };
    // Too few differ to tell.
    let now = Some(wrong(yours, (0, 0))).filter(|&now| places.len() / 50 < now)?;
    let turns = [
        ("mirrored from left to right", imageops::flip_horizontal(yours)),
        ("upside down", imageops::flip_vertical(yours)),
        ("turned by 180°", imageops::rotate180(yours)),
    ];
    let turn = turns.iter().find(|(_, turned)| 2 * wrong(turned, (0, 0)) < now);
    if let Some((how, _)) = turn {
        return Some((*how).to_owned());
    }
    let moves = (-16..=16).flat_map(|y| (-16..=16).map(move |x| (x, y)));
    let (left, (x, y)) = moves.map(|by| (wrong(yours, by), by)).min()?;
    let way = |by: i64, back: &str, on: &str| match by {
        0 => None,
        1.. => Some(format!("{by} {back}")),
        _ => Some(format!("{} {on}", -by)),
    };
    let ways = [way(x, "to the left", "to the right"), way(y, "up", "down")];
    let ways: Vec<_> = ways.into_iter().flatten().collect();
    (2 * left < now).then(|| format!("moved by pixels: {}", ways.join(", ")))
}
