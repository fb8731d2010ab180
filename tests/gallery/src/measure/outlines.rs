use super::knobs::{self, Knob};
use super::look::{hit, near};
use super::words::percent;
use super::{Alternative, Eye, Look, Place, Stage, Verdict, alternatives, nearest};
use crate::{Parts, Section, Step, section};

/// The stage of the outlines: which pixels see an object at all. What explains wrong
/// ones becomes part of what is known.
pub(super) fn stage(look: &mut Look) -> Stage {
    let (mut section, test) = (section::MEETING, Some("coefficients_of_a_pixel"));
    let name = "outlines";
    if look.eye == Eye::Unknown && is_turned_round(look) {
        let told = "the sky is where the objects should be, and the objects are where the \
                    sky should be: Some and None, or hit and miss, have changed places";
        (look.has_shapes, section) = (false, section::ONE_COLOUR);
        let numbers = vec![told.to_owned()];
        return Stage { name, verdict: Verdict::Wrong, numbers, section, test };
    }
    if look.eye == Eye::Unknown && !has_no_sky(look) {
        let why = "no sky can be told from the objects".to_owned();
        look.has_shapes = false;
        return Stage {
            name,
            verdict: Verdict::Unknown(why),
            numbers: vec![],
            section,
            test,
        };
    }
    let places = look.places();
    let wrong = wrong(look, &places);
    if wrong.is_empty() {
        let (mut verdict, mut numbers) = (Verdict::Right, vec![]);
        if let Some((its, mut parts, told)) = hidden(look, &places) {
            (verdict, section) = (Verdict::Wrong, its);
            numbers.push(told);
            look.theirs = parts.remove(0);
        } else if look.is_smooth && !is_mixed(look, &places) {
            let why =
                "its edges are mixed, and no number of samples alone mixes them so";
            verdict = Verdict::Unknown(why.to_owned());
        }
        return Stage { name, verdict, numbers, section, test };
    }
    let mut numbers = counted(&wrong, &places);
    match explained(look, &places, &wrong) {
        Some((its, mut parts, told)) => {
            section = its;
            numbers.push(told);
            look.theirs = parts.remove(0);
            look.others = parts;
        }
        None if look.eye == Eye::Unknown => {
            let why = "no sky can be told from the objects".to_owned();
            let verdict = Verdict::Unknown(why);
            look.has_shapes = false;
            return Stage { name, verdict, numbers: vec![], section, test };
        }
        None => {
            numbers.extend(lost(look, &places));
            look.has_shapes = false;
        }
    }
    Stage { name, verdict: Verdict::Wrong, numbers, section, test }
}

/// Whether some number of rays a pixel gives the colours of the edges.
fn is_mixed(look: &mut Look, places: &[Place]) -> bool {
    let edges = places.iter().filter(|p| p.i % 7 == 3 && look.is_edge(p.i, p.j));
    let edges: Vec<_> = edges.take(60).collect();
    let found = (2..=16).find(|&samples| {
        let is_it = |p: &&&Place| {
            let ours = look.theirs.pixel(look.step, samples, p.i, p.j);
            near(look.yours.get_pixel(p.i, p.j), &ours)
        };
        10 * edges.iter().filter(is_it).count() >= 9 * edges.len()
    });
    look.samples = found.unwrap_or(1);
    found.is_some()
}

/// Whether the sky is where the objects should be, and no sky where it should be.
fn is_turned_round(look: &Look) -> bool {
    let places = look.places();
    let turned = places.iter().filter(|p| p.is_sky == p.hit.is_some()).count();
    places.len() * 99 < turned * 100
}

/// Whether no place looks like the right sky, so that there may be none.
fn has_no_sky(look: &Look) -> bool {
    let places = look.places();
    let is_known = |p: &&Place| nearest::shown(look, p).is_some();
    let known = places.iter().filter(is_known).count();
    let sky = places.iter().filter(|p| p.is_sky).count();
    let is_flat = look.step <= Step::Nearest;
    sky * 100 < places.len() && (!is_flat || places.len() < 2 * known)
}

/// The places where one sees the sky and should not, or the other way round.
fn wrong(look: &Look, places: &[Place]) -> Vec<Place> {
    let is_loose = look.is_loose() || look.eye != Eye::Right;
    let all = places.iter().filter(|place| place.is_sky == place.hit.is_some());
    let wrong: Vec<_> = all
        .filter(|place| !is_loose || !look.is_edge(place.i, place.j))
        .copied()
        .collect();
    // A camera that is known to a few digits moves edges by a hair.
    if look.eye == Eye::Read && wrong.len() * 1000 < places.len() {
        return vec![];
    }
    // A lit object may have the sky's colour along a line, away from its outline.
    let inside =
        wrong.iter().filter(|p| p.is_sky && !look.is_edge(p.i, p.j)).count();
    let is_chance = Step::Diffuse <= look.step
        && wrong.iter().all(|p| p.is_sky)
        && 10 * inside >= 6 * wrong.len()
        && wrong.len() * 1000 < places.len();
    if is_chance { vec![] } else { wrong }
}

fn counted(wrong: &[Place], places: &[Place]) -> Vec<String> {
    let missing = wrong.iter().filter(|place| place.is_sky).count();
    let seen = places.iter().filter(|place| place.hit.is_some()).count();
    let extra = wrong.len() - missing;
    let parts = [
        (missing, seen, "of the pixels that should see an object see the sky"),
        (
            extra,
            places.len() - seen,
            "of those that should see the sky see an object",
        ),
    ];
    let parts = parts.iter().filter(|(count, ..)| 0 < *count);
    parts
        .map(|(count, all, what)| format!("{} {what}", percent(*count, *all)))
        .collect()
}

/// Which objects lack some of their pixels.
fn lost(look: &Look, places: &[Place]) -> Vec<String> {
    let objects = look.theirs.objects(look.step);
    let of = |k: usize| places.iter().filter(move |place| place.hit == Some(k));
    let lost = |k: usize| of(k).filter(|place| place.is_sky).count();
    (0..objects.len())
        .filter(|&k| 0 < lost(k) && look.step != Step::Sphere)
        .map(|k| {
            let share = percent(lost(k), of(k).count());
            format!(
                "{share} of {} is sky in your picture",
                objects[k].material.name
            )
        })
        .collect()
}

/// The section, the parts that explain it, and what is told.
type Explained = (Section, Vec<Parts>, String);

/// What explains nearly all of the outlines: another formula, or another number.
fn explained(look: &Look, places: &[Place], wrong: &[Place]) -> Option<Explained> {
    let few = places.iter().step_by(places.len() / 2500 + 1);
    let sample: Vec<_> =
        few.chain(wrong.iter().step_by(wrong.len() / 1500 + 1)).copied().collect();
    let before = misses(look, &look.theirs, &sample);
    let is_near = |misses: usize| misses * 12 <= before;
    let formulas = formulas(look).map(|one| {
        let mut parts = look.theirs.clone();
        (one.change)(&mut parts);
        (misses(look, &parts, &sample), one, parts)
    });
    let formulas: Vec<_> =
        formulas.filter(|(misses, ..)| is_near(*misses)).collect();
    let least = formulas.iter().map(|(misses, ..)| *misses).min();
    let knob = number(look, places, &sample);
    match (least, knob) {
        (Some(least), knob)
            if knob.as_ref().is_none_or(|(misses, ..)| least <= *misses) =>
        {
            let best = formulas.iter().filter(|(misses, ..)| *misses == least);
            let best: Vec<_> = best.collect();
            let parts = best.iter().map(|(_, _, parts)| parts.clone()).collect();
            Some((best.first()?.1.section, parts, names(&best)))
        }
        (_, Some((_, knob, parts))) => {
            let told = knob.told(&parts, &look.right, look.step);
            Some((knob.section(look.step), vec![parts], told))
        }
        _ => None,
    }
}

/// The number of the scene that explains the sample, and how much it leaves over.
fn number(
    look: &Look,
    places: &[Place],
    sample: &[Place],
) -> Option<(usize, Knob, Parts)> {
    let before = misses(look, &look.theirs, sample);
    let shapes = match look.step {
        Step::Sphere => vec![0],
        _ => knobs::suspects(look, places),
    };
    let mut telling = knobs::telling(look, places, 300);
    let is_wrong =
        |p: &&Place| 0 < misses(look, &look.theirs, std::slice::from_ref(p));
    telling.extend(sample.iter().filter(is_wrong).take(200));
    let its: Vec<_> = places
        .iter()
        .filter(|p| p.hit.is_some_and(|k| shapes.contains(&k)))
        .collect();
    telling.extend(its.iter().step_by(its.len() / 400 + 1).copied());
    let turned = knobs::turned(look, &Knob::shapes(&shapes), &telling);
    let turned = turned?;
    let mut parts = look.theirs.clone();
    knobs::set(&mut parts, &turned, look.step);
    let misses = misses(look, &parts, sample);
    (misses * 50 <= before).then_some((misses, turned.knob, parts))
}

/// In step 3, the number that explains an outline which lies before other objects, where
/// no other way to choose a hit does.
fn hidden(look: &Look, places: &[Place]) -> Option<Explained> {
    let is_wrong =
        |p: &&Place| nearest::shown(look, p).is_some_and(|k| p.hit != Some(k));
    let wrong = places.iter().filter(|p| !p.is_sky).filter(is_wrong);
    let wrong: Vec<_> = wrong.copied().collect();
    if look.step != Step::Nearest || wrong.len() < 12 || look.is_smooth {
        return None;
    }
    let few = places.iter().step_by(places.len() / 2500 + 1);
    let sample: Vec<_> =
        few.chain(wrong.iter().step_by(wrong.len() / 800 + 1)).copied().collect();
    let (_, knob, parts) = nearest::explained(look, places)
        .is_none()
        .then(|| number(look, places, &sample))??;
    let told = knob.told(&parts, &look.right, look.step);
    Some((knob.section(look.step), vec![parts], told))
}

/// All that give these outlines, in words.
fn names(best: &[&(usize, Alternative, Parts)]) -> String {
    let names: Vec<_> = best.iter().map(|(_, one, _)| one.when).collect();
    format!("these outlines are what you get when {}", names.join("; or when "))
}

/// What may change outlines.
fn formulas(look: &Look) -> impl Iterator<Item = Alternative> + use<> {
    let steps = Step::Sphere..=look.step.min(Step::Nearest);
    let right = look.right.clone();
    alternatives().filter(move |one| {
        let mut parts = right.clone();
        (one.change)(&mut parts);
        // The sky does not tell where the rays start, nor a V_z that its blue clamps.
        let [a, b] = [&parts, &right].map(|p| {
            (p.camera.centre, p.camera.matrix.row(0), p.camera.matrix.row(1))
        });
        let is_deeper = parts.camera.matrix.z_axis.z < right.camera.matrix.z_axis.z;
        let is_moved = a.0 != b.0 || is_deeper && (a.1, a.2) == (b.1, b.2);
        is_moved || steps.contains(&one.section.step)
    })
}

/// How often one sees the sky and should not, or the other way round; in step 3, how
/// often one sees another object, too.
fn misses(look: &Look, parts: &Parts, places: &[Place]) -> usize {
    let is_miss = |place: &&Place| {
        let hit = hit(parts, look.step, place.i.into(), place.j.into());
        match look.step {
            Step::Nearest if !place.is_sky => hit != nearest::shown(look, place),
            _ => hit.is_none() != place.is_sky,
        }
    };
    places.iter().filter(is_miss).count()
}
