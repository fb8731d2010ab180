use super::Sky;
use super::reading::Seen;
use super::words::{list, number, vector};
use crate::{Step, camera};
use gallery::Parts;
use glam::{DMat3, DVec3};
use image::RgbImage;
use step01_rays::Ray;

/// What is wrong where a sky is that of other rays than ours.
pub(super) enum Told {
    /// The camera: the numbers of it, theirs and ours.
    Rays(Vec<String>),
    /// The camera or the colour of the sky, and why it can't be told which.
    Either(&'static str, Vec<String>),
    /// The colour of the sky alone, for the objects are where our rays see them, but for
    /// so many pixels.
    Sky(Vec<String>, usize),
}

/// What the sky tells of a camera that no known formula gives.
///
/// None where no sky tells it, or where the objects are not where it would see them.
pub(super) fn read(yours: &RgbImage, step: Step, seen: &[Seen]) -> Option<Told> {
    let (width, height) = yours.dimensions();
    // What is the same everywhere is one colour, and no sky.
    let sky = Sky::of(yours).filter(|sky| !sky.is_even())?;
    let off = || seen.iter().filter_map(|s| sky.off(yours, s.place));
    let on = off().filter(|off| *off < NEAR).count();
    // What bends away from a plane, as after a power, is no sky of other rays.
    let beside = off().filter(|off| (NEAR..8.0).contains(off)).count();
    let share = on as f64 / seen.len().max(1) as f64;
    let least = if step == Step::Rays { 0.97 } else { 0.2 };
    let is_sky = least < share && 8 * beside < on;
    let ours = camera(width, height).matrix;
    if is_dimmed(&sky, &ours) || is_rounded(&sky, &ours, (width, height)) {
        return None;
    }
    let is_object =
        |s: &&Seen| sky.off(yours, s.place).is_none_or(|off| NEAR <= off);
    let others = seen.iter().filter(|s| is_object(s) != s.object.is_some()).count();
    // Where the rays of this sky would see the objects.
    let parts = Parts::right(&camera(width, height));
    let few = || seen.iter().step_by(seen.len() / 4000 + 1);
    let is_elsewhere = |s: &&Seen| {
        let place = DVec3::new(s.place.0.into(), s.place.1.into(), 1.0);
        let direction = sky.matrix * place;
        let point = parts.seen(step, &Ray { start: DVec3::ZERO, direction });
        is_object(s) != point.is_some()
    };
    let is_ours =
        others * 60 < seen.len() && 8.0 < shift(&sky, &ours, (width, height));
    let objects = few().filter(is_object).count();
    let is_else = objects < 8 * few().filter(is_elsewhere).count();
    let is_even = is_even(&sky, &ours);
    let told = match (step, is_ours, is_else) {
        (Step::Rays, ..) if is_even => |all, _| Told::Either(EVEN, all),
        (Step::Rays, ..) | (_, false, false) => |all, _| Told::Rays(all),
        (_, true, _) => Told::Sky,
        _ => |all, _| Told::Either(NEITHER, all),
    };
    let is_camera = matches!(told(vec![], 0), Told::Rays(_));
    let whose = if is_camera { "your" } else { "by the sky's colours," };
    let numbers = differences(&sky, &ours, whose);
    (is_sky && !numbers.is_empty()).then(|| told(numbers, others))
}

const NEITHER: &str = "the objects are where neither our rays see them nor those that the \
                       sky's colours tell";

const EVEN: &str = "other rays give this sky, and so do other numbers than 0.7 and 0.3 in its \
                    colours";

/// So far off, in parts of V that one byte may be off, a pixel may be of a sky.
const NEAR: f64 = 1.5;

/// How many columns or rows a ray in the middle of a quarter of the picture is away from
/// ours, where that is least.
fn shift(sky: &Sky, ours: &DMat3, (width, height): (u32, u32)) -> f64 {
    let quarters = [(1, 1), (1, 3), (3, 1), (3, 3)];
    let quarter = |size: u32, k: u32| f64::from(size * k) / 4.0;
    let shift = |(k, l): (u32, u32)| {
        let place = DVec3::new(quarter(width, k), quarter(height, l), 1.0);
        let off = ((sky.matrix - *ours) * place).truncate();
        off.length() / ours.x_axis.x
    };
    quarters.map(shift).into_iter().fold(f64::INFINITY, f64::min)
}

/// Whether x and y of other rays are those of ours, so many times as large and moved by
/// the same: as other numbers in the colours of the sky would have it.
fn is_even(sky: &Sky, ours: &DMat3) -> bool {
    let times = sky.matrix.x_axis.x / ours.x_axis.x;
    let by = sky.matrix.z_axis - times * ours.z_axis;
    let far = 0.02 + 5.0 * sky.errors[2];
    (sky.matrix.y_axis.y / ours.y_axis.y - times).abs() < 0.02 * times.abs()
        && (by.x - by.y).abs() < far
        && far < by.x.abs()
}

/// Whether the colours of a sky are those of our rays, but so many times as bright: then
/// they tell of no other rays.
fn is_dimmed(sky: &Sky, ours: &DMat3) -> bool {
    let brightness = sky.matrix.x_axis.x / ours.x_axis.x;
    // 0.7 + 0.3 V so many times is 0.7 + 0.3 V' of this V'.
    let other = |v: f64| brightness * v + (brightness - 1.0) * 7.0 / 3.0;
    let is_it = |yours: f64, ours: f64| (yours - ours).abs() < 0.02;
    is_it(sky.matrix.y_axis.y / ours.y_axis.y / brightness, 1.0)
        && is_it(sky.matrix.z_axis.x, other(ours.z_axis.x))
        && is_it(sky.matrix.z_axis.y, other(ours.z_axis.y))
        && !is_it(brightness, 1.0)
}

/// Whether the colours of a sky are those of our rays, but all darker or brighter by about
/// half a byte: then they tell how bytes are rounded.
fn is_rounded(sky: &Sky, ours: &DMat3, (width, height): (u32, u32)) -> bool {
    let by = sky.matrix - *ours;
    let across = by.x_axis * f64::from(width);
    let down = by.y_axis * f64::from(height);
    let middle = by.z_axis + (across + down) / 2.0;
    let half = 0.5 / (0.3 * 255.0);
    let is_half = |x: f64| (x.abs() - half).abs() < 0.3 * half;
    is_half(middle.x)
        && (middle.x - middle.y).abs() < 0.3 * half
        && (across.abs() + down.abs()).max_element() < half
}

/// How the columns of a matrix differ from those of ours, as far as can be told.
fn differences(sky: &Sky, ours: &DMat3, whose: &str) -> Vec<String> {
    let mut numbers = vec![];
    for (k, name) in ["D_u", "D_v", "V_0"].into_iter().enumerate() {
        let (yours, ours, error) =
            (sky.matrix.col(k), ours.col(k), 5.0 * sky.errors[k]);
        if error < (yours - ours).abs().max_element() {
            let why = list(&ratios(yours, ours, error));
            let why = if why.is_empty() { why } else { format!(": {why}") };
            let clean = yours.map(|x| if x.abs() < error { 0.0 } else { x });
            numbers.push(format!(
                "{whose} {name} is about {}; it should be {}{why}",
                vector(clean),
                vector(ours)
            ));
        }
    }
    numbers
}

/// How many times ours the parts are that are wrong.
fn ratios(yours: DVec3, ours: DVec3, error: f64) -> Vec<String> {
    let parts = ["x", "y", "z"].into_iter().enumerate();
    let wrong = parts
        .filter(|&(k, _)| error <= (yours[k] - ours[k]).abs() && ours[k] != 0.0);
    wrong
        .map(|(k, part)| {
            format!("its {part} is {} times ours", number(yours[k] / ours[k]))
        })
        .collect()
}
