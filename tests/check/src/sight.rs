use crate::apart;
use crate::view::View;
use crate::{Parts, Step, camera, each};
use image::{Rgb, RgbImage};
use std::fmt::Write;

/// What can be seen of the difference between two pictures of one size, in sentences,
/// each on a line.
pub(crate) fn seen(yours: &View, ours: &RgbImage, step: Option<Step>) -> String {
    let text = region(yours, ours);
    match step.filter(|&step| step != Step::Rays) {
        Some(step) => text + &objects(yours, ours, step),
        None => text,
    }
}

/// How many pixels differ, how far and where.
pub(crate) fn region(yours: &View, ours: &RgbImage) -> String {
    let stride = yours.stride;
    let places: Vec<_> = yours
        .kept
        .enumerate_pixels()
        .zip(ours.pixels())
        .map(|((i, j, yours), ours)| (i * stride, j * stride, apart(yours, ours)))
        .filter(|&(.., apart)| 0 < apart)
        .collect();
    let all = match yours.kept.pixels().len() {
        all if stride == 1 => all.to_string(),
        some => format!("the {some} pixels that were compared"),
    };
    let within = |values: Vec<u32>| {
        let least = values.iter().min().copied().unwrap_or(0);
        format!("{least} to {}", values.iter().max().copied().unwrap_or(0))
    };
    let differ = match (stride, places.len()) {
        (1, 1) => format!("1 of {all} pixels differs"),
        (1, count) => format!("{count} of {all} pixels differ"),
        (_, count) => format!("{count} of {all} differ"),
    };
    format!(
        "{differ}, by up to {} of 255, in columns {} and rows {}.\n",
        places.iter().map(|&(.., apart)| apart).max().unwrap_or(0),
        within(places.iter().map(|&(i, ..)| i).collect()),
        within(places.iter().map(|&(_, j, _)| j).collect()),
    )
}

/// On which objects the pictures differ, and which are right.
fn objects(yours: &View, ours: &RgbImage, step: Step) -> String {
    let ((width, height), stride) = (yours.size, yours.stride);
    let parts = Parts::right(&camera(width, height));
    let names = parts.objects(step).iter().map(|object| object.material.name);
    let names: Vec<_> = names.chain(["the sky"]).collect();
    // Of each: how many pixels see it, how many of them differ, by how much in all.
    let row = |j: u32| {
        let mut found = vec![[0; 3]; names.len()];
        for i in 0..yours.kept.width() {
            let (a, b) = (yours.kept.get_pixel(i, j), ours.get_pixel(i, j));
            let ray = parts.camera.ray((i * stride).into(), (j * stride).into());
            let point = parts.seen(step, &ray);
            let name = point.map_or("the sky", |point| point.material.name);
            let counts = [1, i64::from(a != b), sum(a) - sum(b)];
            if let Some(k) = names.iter().position(|other| *other == name) {
                (0..3).for_each(|which| found[k][which] += counts[which]);
            }
        }
        Some(found)
    };
    let rows = each((0..yours.kept.height()).collect(), row);
    let (mut wrong, mut right) = (vec![], vec![]);
    for (k, name) in names.into_iter().enumerate() {
        let total = |which: usize| rows.iter().map(|row| row[k][which]).sum();
        let [all, differ, lighter]: [i64; 3] = [0, 1, 2].map(total);
        match (all, differ) {
            (0, _) => {}
            (_, 0) => right.push(name),
            _ => wrong.push(format!(
                "{name} ({}{})",
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
