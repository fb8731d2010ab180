use super::words::{number, percent, vector};
use super::{Look, Place, Stage, Verdict};
use crate::section;
use glam::DVec3;

/// The stage of the nearest hit, where each object has one flat colour.
pub(super) fn stage(look: &Look, places: &[Place]) -> Stage {
    let (verdict, numbers) = verdict(look, places);
    let test = Some("nearest_in_a_crowd");
    Stage { name: "nearest", verdict, numbers, section: section::NEAREST, test }
}

/// The object of whose colour a pixel is.
fn shown(look: &Look, place: &Place) -> Option<usize> {
    let objects = look.theirs.objects(look.step);
    let yours = *look.yours.get_pixel(place.i, place.j);
    let of = |k: usize| objects[k].material.material.surface.diffuse;
    (0..objects.len()).find(|&k| look.bytes.write(of(k)) == yours)
}

fn verdict(look: &Look, places: &[Place]) -> (Verdict, Vec<String>) {
    let is_loose = look.is_smooth || !look.is_right_camera;
    let seen = places.iter().filter(|place| place.hit.is_some() && !place.is_sky);
    let wrong: Vec<_> = seen
        .clone()
        .map(|place| (place, shown(look, place)))
        .filter(|(place, shown)| *shown != place.hit)
        .filter(|(p, _)| !is_loose || !look.is_edge(&look.theirs, p.i, p.j))
        .collect();
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
    (Verdict::Wrong, numbers)
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
