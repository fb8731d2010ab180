use super::classes;
use super::table::{blank, row};
use super::view::{is_blurred, mixed, views};
use super::words::percent;
use super::{Stage, Verdict, camera};
use crate::formula::{Changed, Context, Pixel, Tree, Values, batch};
use crate::{Step, apart, each};
use glam::DVec3;
use image::{Rgb, RgbImage};

/// One pixel, and what ours is made of there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub place: (u32, u32),
    pub yours: Rgb<u8>,
    pub ours: Rgb<u8>,
    /// What the sky would be here.
    pub sky: Rgb<u8>,
    /// The object that is seen, if one is.
    pub object: Option<usize>,
    pub ambient: DVec3,
    /// Of each light.
    pub diffuse: [DVec3; 2],
    pub specular: [DVec3; 2],
    pub distances: [f64; 2],
    pub cosines: [f64; 2],
}

impl Seen {
    /// Whether it is right, to the last byte.
    pub fn is_right(&self) -> bool {
        self.yours == self.ours
    }
}

/// The stages of a picture that nothing explains, as far as classes of its pixels tell
/// them.
pub(super) fn stages(
    yours: &RgbImage,
    step: Step,
    places: &[(u32, u32)],
) -> Vec<Stage> {
    let some = |count: usize| -> Vec<_> {
        places.iter().step_by(places.len() / count + 1).copied().collect()
    };
    let views = views(yours, mixed(yours).is_some());
    let few = some(6000);
    let read =
        views.iter().filter(|view| view.samples == views[0].samples).map(|view| {
            let tree = Tree::new(step, yours.dimensions(), view.fov, 1);
            (agreeing(&seen(&tree, yours, &few)), view.fov, tree)
        });
    let best = read.max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, fov, tree)) = best else { return vec![] };
    let seen = seen(&tree, yours, &some(60_000));
    let share = agreeing(&seen);
    let why = "nothing that is known explains enough of the picture";
    let mut stages = blank(step, |_| Verdict::Unknown(why.to_owned()));
    let Some(share) = (share.is_finite() && 0.0 <= share).then_some(share) else {
        return stages;
    };
    let is_option = fov != crate::fov::FOV;
    if share < 0.6 {
        match (!is_option).then(|| camera::read(yours, step, &seen)).flatten() {
            Some(camera::Told::Rays(numbers)) => {
                put(&mut stages, "rays", Verdict::Wrong, numbers);
                for stage in stages.iter_mut().skip(1) {
                    let why = "the rays have to be right first".to_owned();
                    stage.verdict = Verdict::Unknown(why);
                }
            }
            Some(camera::Told::Either(why, numbers)) => {
                let why = || Verdict::Unknown(why.to_owned());
                put(&mut stages, "rays", why(), numbers);
                put(&mut stages, "sky", why(), vec![]);
            }
            Some(camera::Told::Sky(numbers, others)) => {
                let why = "the objects are where our rays see them".to_owned();
                put(&mut stages, "rays", Verdict::Unknown(why), vec![]);
                put(&mut stages, "sky", Verdict::Wrong, numbers);
                put(&mut stages, "outlines", outlined(others), vec![]);
                coloured(&tree, &seen, &mut stages);
            }
            None => {}
        }
        return stages;
    }
    let is_smooth = views[0].samples != 1;
    let sky = seen.iter().filter(|s| s.object.is_none());
    let right = sky.clone().filter(|s| s.is_right()).count();
    let all = sky.count();
    let verdict = if right == all && !is_option {
        Verdict::Right
    } else {
        let share = percent(right, all);
        Verdict::Unknown(format!(
            "right in {share} of the pixels that should see the sky"
        ))
    };
    put(&mut stages, "rays", verdict.clone(), vec![]);
    put(&mut stages, "sky", verdict, vec![]);
    if Step::Sphere <= step
        && !is_smooth
        && outlines(yours, &tree, &seen, &mut stages)
    {
        coloured(&tree, &seen, &mut stages);
    }
    stages
}

/// Tells the colours of what has right outlines.
fn coloured(tree: &Tree, seen: &[Seen], stages: &mut [Stage]) {
    match tree.step {
        Step::Sphere | Step::Nearest => flat(tree, seen, stages),
        _ => classes::tell(seen, stages),
    }
}

/// Outlines with so many pixels that may be wrong.
fn outlined(others: usize) -> Verdict {
    match others {
        0 => Verdict::Right,
        some => {
            Verdict::Unknown(format!("{some} pixels may be objects or the sky"))
        }
    }
}

pub(super) fn put(
    stages: &mut [Stage],
    name: &str,
    verdict: Verdict,
    numbers: Vec<String>,
) {
    for stage in stages.iter_mut().filter(|stage| stage.name == name) {
        stage.verdict = verdict.clone();
        stage.numbers = numbers.clone();
    }
}

/// The share of the pixels of the sky that are right; below 0 where too few should be
/// sky.
fn agreeing(seen: &[Seen]) -> f64 {
    let sky = seen.iter().filter(|s| s.object.is_none());
    let right =
        sky.clone().filter(|s| s.is_right() && !is_clamped(&s.yours)).count();
    let all = sky.filter(|s| !is_clamped(&s.ours)).count();
    if all * 50 < seen.len() { -1.0 } else { right as f64 / all as f64 }
}

/// Whether red and green tell nothing.
fn is_clamped(pixel: &Rgb<u8>) -> bool {
    matches!(pixel[0], 0 | 255) && matches!(pixel[1], 0 | 255)
}

/// What is seen at some pixels.
fn seen(tree: &Tree, yours: &RgbImage, places: &[(u32, u32)]) -> Vec<Seen> {
    let context = Context::plain(tree);
    let needed = |name: &str| tree.find(name).filter(|k| tree.lines[*k].is_needed);
    let [nearest, sky, ambient, diffuse, specular, distance, light, normal] =
        ["nearest", "sky", "I_a", "I_d", "G", "d", "l", "n"].map(needed);
    let seen = |values: &Changed, k: usize, place: Pixel, ours: [u8; 3]| {
        let of = |line: Option<usize>, which: usize| {
            let value = line.map(|line| values.name(line, which));
            value.map_or(DVec3::ZERO, |value| value.vector(k))
        };
        let object = if nearest.is_some() { of(nearest, 0).x } else { -1.0 };
        let sky = (255.0 * of(sky, 0) + 0.5).to_array().map(|c| c as u8);
        let n = of(normal, 0);
        let two = |line| [0, 1].map(|which| of(line, which));
        Seen {
            place,
            yours: *yours.get_pixel(place.0, place.1),
            ours: Rgb(ours),
            sky: Rgb(sky),
            object: (0.0 <= object).then_some(object as usize),
            diffuse: two(diffuse),
            specular: two(specular),
            distances: two(distance).map(|d| d.x),
            cosines: two(light).map(|l| l.dot(n)),
            ambient: of(ambient, 0),
        }
    };
    let some = |places: &[Pixel]| {
        let values = Values::at(tree, places, 1);
        let values = values.changed(&context);
        let ours: Vec<_> =
            places.iter().copied().zip(values.pixels()).enumerate().collect();
        let its = ours.into_iter();
        let its = its.map(|(k, (place, ours))| seen(&values, k, place, ours));
        Some(its.collect::<Vec<_>>())
    };
    each(places.chunks(batch(1)).collect(), some).concat()
}

/// Tells the outlines; false where they are not right.
fn outlines(
    yours: &RgbImage,
    tree: &Tree,
    seen: &[Seen],
    stages: &mut [Stage],
) -> bool {
    let objects = || seen.iter().filter(|s| s.object.is_some());
    let lost = |s: &&Seen| s.yours == s.sky && s.ours != s.sky;
    let missing = objects().filter(lost).count();
    let extra: Vec<_> =
        seen.iter().filter(|s| s.object.is_none() && !s.is_right()).collect();
    let far = extra.iter().filter(|s| 6 < apart(&s.yours, &s.ours)).count();
    let (all, sky) = (objects().count(), seen.len() - objects().count());
    if extra.is_empty() && missing * 500 <= all && 0 < all {
        put(stages, "outlines", outlined(missing), vec![]);
        return true;
    }
    let is_wrong = seen.len() < 200 * (missing + far) && extra.len() < 2 * far + 1
        || 20 * missing > all && extra.is_empty();
    if is_wrong && is_blurred(yours) {
        let why = "the edges are blurred: they are wider than one pixel".to_owned();
        put(stages, "outlines", Verdict::Unknown(why), vec![]);
    } else if is_wrong {
        let mut numbers = vec![];
        if 0 < missing {
            let share = percent(missing, all);
            numbers.push(format!(
                "{share} of the pixels that should see an object see the sky"
            ));
        }
        if 0 < far {
            let share = percent(far, sky);
            numbers.push(format!(
                "{share} of those that should see the sky see something else"
            ));
        }
        for object in 0..tree.count(crate::formula::Of::Object) {
            let its = || objects().filter(|s| s.object == Some(object));
            let gone = its().filter(lost).count();
            if 0 < gone {
                let share = percent(gone, its().count());
                numbers.push(format!(
                    "{share} of {} is sky in your picture",
                    tree.object(object)
                ));
            }
        }
        numbers.push("or else V_z is wrong, which the sky hardly shows".to_owned());
        put(stages, "outlines", Verdict::Wrong, numbers);
    }
    for stage in stages
        .iter_mut()
        .filter(|s| !["rays", "sky", "outlines"].contains(&row(s).stage))
    {
        stage.verdict =
            Verdict::Unknown("the outlines have to be right first".to_owned());
    }
    false
}

/// Tells the flat colours, where each object has one.
fn flat(tree: &Tree, seen: &[Seen], stages: &mut [Stage]) {
    let mut numbers = vec![];
    let mut is_told = true;
    for object in 0..tree.count(crate::formula::Of::Object) {
        let its: Vec<_> =
            seen.iter().filter(|s| s.object == Some(object)).collect();
        let Some(first) = its.get(its.len() / 2) else { continue };
        let same = its.iter().filter(|s| s.yours == first.yours).count();
        let is_other = seen.iter().any(|s| {
            s.object.is_some_and(|other| other != object) && s.ours == first.yours
        });
        if first.is_right() && same == its.len() {
            continue;
        }
        if same != its.len() || is_other || its.len() < 12 {
            is_told = false;
            continue;
        }
        let colour = first.yours.0.map(|c| f64::from(c) / 255.0);
        let [yours, ours] = [colour, first.ours.0.map(|c| f64::from(c) / 255.0)];
        let text = |c: [f64; 3]| {
            let c = c.map(|c| (c * 100.0).round() / 100.0);
            super::vector(DVec3::from_array(c))
        };
        numbers.push(format!(
            "the colour of {} is about {} in your picture; it should be {}",
            tree.object(object),
            text(yours),
            text(ours)
        ));
    }
    if !numbers.is_empty() {
        put(stages, "colours", Verdict::Wrong, numbers);
        if is_told {
            put(stages, "nearest", Verdict::Right, vec![]);
        }
    }
}
