//! Numbers of the scene that a reader may have typed differently.

use crate::comparison::{Budget, Comparison};
use crate::number_format::{format_as_typed, with_minus};
use crate::step_scene::StepScene;
use course::{OwnScene, Owner, QUANTITIES, Typed};

/// Describes each change of one number of the scene that gives the reader's picture in every
/// pixel.
pub(crate) fn find_changed_numbers(
    comparison: &Comparison,
    scene: &StepScene,
    budget: &Budget,
) -> Vec<String> {
    let mut pixels: Vec<_> = comparison.pixels().collect();
    let own = OwnScene::new(scene.own.scene.clone());
    let mut changed = StepScene { own, ..*scene };
    let mut words = vec![];
    for quantity in QUANTITIES {
        let Some(typed) = quantity.typed.filter(|typed| typed.since <= scene.step) else {
            continue;
        };
        for (k, owner) in owner_names(scene, quantity.owner).into_iter().enumerate() {
            let (old, count) = ((quantity.get)(&scene.own, k), quantity.numbers.len());
            for new in all_with_one_number_changed(old, count, typed) {
                (quantity.set)(&mut changed.own, k, new);
                if budget
                    .holds_for_all(&mut pixels, 1, |pixel| changed.bytes(&pixel.ray) == pixel.yours)
                {
                    let [new, old] =
                        [new, old].map(|one| with_minus(&format_as_typed(&one[..count])));
                    words.push(format!("{} of {owner} = {new} instead of {old}", quantity.name));
                }
            }
            (quantity.set)(&mut changed.own, k, old);
        }
    }
    words
}

/// The names of all owners of one kind, such as all objects.
pub(crate) fn owner_names(scene: &StepScene, owner: Owner) -> Vec<String> {
    match owner {
        Owner::Object => scene.object_names(),
        Owner::Light => scene.light_names.map(str::to_owned).to_vec(),
        Owner::Scene | Owner::Camera => vec!["the scene".to_owned()],
    }
}

/// All ways to change one of these numbers to a value that somebody may have typed. If the
/// quantity has one number, it is in all three places.
fn all_with_one_number_changed(
    old: [f64; 3],
    count: usize,
    Typed { range: [start, end], steps_per_unit, .. }: Typed,
) -> impl Iterator<Item = [f64; 3]> {
    (0..count).flat_map(move |k| {
        let values = start * steps_per_unit..=end * steps_per_unit;
        let values = values.map(move |value| f64::from(value) / f64::from(steps_per_unit));
        let typed = old[k];
        values.filter(move |value| *value != typed).map(move |value| {
            let mut new = if count == 1 { [value; 3] } else { old };
            new[k] = value;
            new
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TYPED: Typed = Typed { since: course::Step::Rays, range: [0, 1], steps_per_unit: 2 };

    #[test]
    fn one_number_is_changed_at_a_time() {
        let changed: Vec<_> = all_with_one_number_changed([0.0, 1.0, 7.0], 3, TYPED).collect();
        let expected = [
            [0.5, 1.0, 7.0],
            [1.0, 1.0, 7.0],
            [0.0, 0.0, 7.0],
            [0.0, 0.5, 7.0],
            [0.0, 1.0, 0.0],
            [0.0, 1.0, 0.5],
            [0.0, 1.0, 1.0],
        ];
        assert_eq!(changed, expected);
    }

    #[test]
    fn single_number_is_changed_in_all_places() {
        let changed: Vec<_> = all_with_one_number_changed([0.5; 3], 1, TYPED).collect();
        assert_eq!(changed, [[0.0; 3], [1.0; 3]]);
    }

    #[test]
    fn owners_have_names() {
        let scene = StepScene::of_step(course::Step::Sphere);
        assert_eq!(owner_names(&scene, Owner::Object), ["the sphere"]);
        assert_eq!(owner_names(&scene, Owner::Light), ["the warm light", "the cool light"]);
        assert_eq!(owner_names(&scene, Owner::Scene), ["the scene"]);
        let named = StepScene::of_name("ada");
        assert_eq!(owner_names(&named, Owner::Object)[..2], ["ball 1", "the ground"]);
    }
}
