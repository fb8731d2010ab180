use super::words::percent;
use super::{Look, Place, Stage, Verdict};
use crate::{Step, section};

/// The stage of the outlines: which pixels see an object at all.
pub(super) fn stage(look: &Look, places: &[Place]) -> Stage {
    let (verdict, numbers) = verdict(look, places);
    let test = Some("coefficients_of_a_pixel");
    Stage { name: "outlines", verdict, numbers, section: section::MEETING, test }
}

fn verdict(look: &Look, places: &[Place]) -> (Verdict, Vec<String>) {
    if look.sky.is_none() && !look.is_right_camera {
        let why = "no sky can be told from the objects".to_owned();
        return (Verdict::Unknown(why), vec![]);
    }
    let is_loose = look.is_smooth || !look.is_right_camera;
    let wrong: Vec<_> = (places.iter())
        .filter(|place| place.is_sky == place.hit.is_some())
        .filter(|place| !is_loose || !look.is_edge(&look.theirs, place.i, place.j))
        .collect();
    if wrong.is_empty() {
        return (Verdict::Right, vec![]);
    }
    let missing = wrong.iter().filter(|place| place.is_sky).count();
    let mut numbers = vec![format!(
        "{} of the pixels that should see an object see the sky, and {} of those that \
         should see the sky do not",
        percent(missing, places.iter().filter(|p| p.hit.is_some()).count()),
        percent(
            wrong.len() - missing,
            places.iter().filter(|p| p.hit.is_none()).count()
        )
    )];
    numbers.extend(lost(look, places));
    (Verdict::Wrong, numbers)
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
