use super::words::{number, percent, vector};
use super::{Alternative, Look, Place, Stage, Verdict, alternatives, hit};
use crate::{Step, section};
use glam::DVec3;

/// The stage of the nearest hit, where each object has one flat colour.
pub(super) fn stage(look: &Look, places: &[Place]) -> Stage {
    let (verdict, numbers) = verdict(look, places);
    let test = Some("nearest_in_a_crowd");
    Stage { name: "nearest", verdict, numbers, section: section::NEAREST, test }
}

/// The object of whose colour a pixel is, None where there is no such.
pub(super) fn shown(look: &Look, place: &Place) -> Option<usize> {
    let objects = look.theirs.objects(look.step);
    let yours = *look.yours.get_pixel(place.i, place.j);
    let of = |k: usize| objects[k].material.material.surface.diffuse;
    (0..objects.len()).find(|&k| look.bytes.write(of(k)) == yours)
}

fn verdict(look: &Look, places: &[Place]) -> (Verdict, Vec<String>) {
    let is_loose = look.is_loose();
    let seen = places.iter().filter(|place| place.hit.is_some() && !place.is_sky);
    let wrong: Vec<_> = seen
        .clone()
        .map(|place| (place, shown(look, place)))
        .filter(|(place, shown)| *shown != place.hit)
        .filter(|(p, _)| !is_loose || !look.is_edge(p.i, p.j))
        .collect();
    let odd =
        wrong.iter().filter(|(place, shown)| !is_met(look, place, *shown)).count();
    if 0 < odd && wrong.len() < 4 * odd {
        let why = "some colours are those of no object there".to_owned();
        return (Verdict::Unknown(why), vec![]);
    }
    let Some((place, _)) = wrong.get(wrong.len() / 2) else {
        return match seen.count() {
            0 => (Verdict::Unknown("no object is seen".to_owned()), vec![]),
            _ => (Verdict::Right, vec![]),
        };
    };
    let share = percent(wrong.len(), seen.count());
    let mut numbers =
        vec![format!("{share} of the objects' pixels show another object")];
    numbers.push(one(look, place));
    numbers.extend(explained(look, places));
    (Verdict::Wrong, numbers)
}

/// The ways to choose a hit that explain every pixel.
pub(super) fn explained(look: &Look, places: &[Place]) -> Option<String> {
    let few: Vec<_> = places.iter().filter(|p| !p.is_sky).collect();
    let few: Vec<_> = few.iter().step_by(few.len() / 3000 + 1).collect();
    let ways = alternatives()
        .filter(|a| [Step::Sphere, Step::Nearest].contains(&a.section.step));
    let is_it = |one: &Alternative| {
        let mut parts = look.theirs.clone();
        (one.change)(&mut parts);
        let is_miss = |p: &&&&Place| {
            hit(&parts, look.step, p.i.into(), p.j.into()) != shown(look, p)
        };
        few.iter().filter(is_miss).count() * 200 <= few.len()
    };
    let names: Vec<_> = ways.filter(is_it).take(4).map(|one| one.when).collect();
    let told = format!("that is what you get when {}", names.join("; or when "));
    (!names.is_empty()).then_some(told)
}

/// Whether the ray of a place meets an object at all.
fn is_met(look: &Look, place: &Place, shown: Option<usize>) -> bool {
    let parts = &look.theirs;
    let ray = (parts.ray)(parts.camera.ray(place.i.into(), place.j.into()));
    shown.is_some_and(|k| {
        let sphere = parts.objects(look.step)[k].sphere;
        sphere.intersect(&ray).first_hit().is_some()
    })
}

/// One pixel that shows the wrong object.
fn one(look: &Look, place: &Place) -> String {
    let Place { i, j, hit, .. } = *place;
    let objects = look.theirs.objects(look.step);
    let t = |k: usize| {
        let ray = (look.theirs.ray)(look.theirs.camera.ray(i.into(), j.into()));
        let t = objects[k].sphere.intersect(&ray).first_hit();
        t.map_or("none".to_owned(), number)
    };
    let name = |k: usize| format!("{} (t = {})", objects[k].material.name, t(k));
    let yours = shown(look, place).map_or_else(
        || {
            let colour: DVec3 = look.bytes.read(look.yours.get_pixel(i, j));
            format!("the colour {}", vector(colour))
        },
        name,
    );
    format!(
        "column {i}, row {j} shows {yours}; it should show {}",
        hit.map_or("the sky".to_owned(), name)
    )
}
