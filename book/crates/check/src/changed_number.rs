//! Finds numbers in the scene that a reader may have mistyped.

use crate::comparison::{Budget, Comparison};
use crate::number_format::{format_with_hyphens, replace_hyphens_with_minus};
use crate::step_scene::StepScene;
use course::{OwnScene, Owner, QUANTITIES, Quantity, TypedRange};

/// Tries changes to a single number in the scene. Returns a description of each change that
/// reproduces the reader's picture exactly.
pub(crate) fn find_changed_numbers(
    comparison: &Comparison,
    scene: &StepScene,
    budget: &Budget,
) -> Vec<String> {
    let mut pixels: Vec<_> = comparison.pixels().collect();
    let own_scene = OwnScene::new(scene.own_scene.scene.clone());
    let mut changed_scene = StepScene { own_scene, ..*scene };
    let mut descriptions = vec![];
    for quantity in QUANTITIES {
        let Some(typed) = quantity.typed.filter(|typed| typed.first_step <= scene.step) else {
            continue;
        };
        for (k, owner) in owner_names(scene, quantity.owner).into_iter().enumerate() {
            for scalar in quantity.scalars {
                let old = scalar.get(&scene.own_scene, k);
                for new in numbers_in_typed_range(typed).filter(|new| *new != old) {
                    scalar.set(&mut changed_scene.own_scene, k, new);
                    let is_found = budget.holds_for_all(&mut pixels, 1, |pixel| {
                        changed_scene.bytes(&pixel.ray) == pixel.yours
                    });
                    if is_found {
                        let [new, old] =
                            [&changed_scene.own_scene, &scene.own_scene].map(|own_scene| {
                                replace_hyphens_with_minus(&format_quantity(quantity, own_scene, k))
                            });
                        descriptions
                            .push(format!("{} of {owner} = {new} instead of {old}", quantity.name));
                    }
                }
                scalar.set(&mut changed_scene.own_scene, k, old);
            }
        }
    }
    descriptions
}

/// Returns the names of everything of this kind. For [`Owner::Object`], these are the names of all
/// objects.
pub(crate) fn owner_names(scene: &StepScene, owner: Owner) -> Vec<String> {
    match owner {
        Owner::Object => scene.object_names(),
        Owner::Light => scene.light_names.map(str::to_owned).to_vec(),
        Owner::Scene | Owner::Camera => vec!["the scene".to_owned()],
    }
}

/// Returns the numbers that somebody is likely to type: the multiples of 1/`steps_per_unit` in a
/// range, in ascending order.
fn numbers_in_typed_range(
    TypedRange { range: [start, end], steps_per_unit, .. }: TypedRange,
) -> impl Iterator<Item = f64> {
    let numerators = start * steps_per_unit..=end * steps_per_unit;
    numerators.map(move |numerator| f64::from(numerator) / f64::from(steps_per_unit))
}

/// Formats a quantity with hyphens as minus signs: `-2.5`, or `(1, -2.5, 0)`. The quantity belongs
/// to the owner with index `owner_index`, for example to an object.
pub(crate) fn format_quantity(
    quantity: &Quantity,
    own_scene: &OwnScene,
    owner_index: usize,
) -> String {
    let numbers: Vec<_> =
        quantity.scalars.iter().map(|scalar| scalar.get(own_scene, owner_index)).collect();
    format_with_hyphens(&numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typed_range_includes_both_ends() {
        let typed = TypedRange { first_step: course::Step::Rays, range: [0, 1], steps_per_unit: 2 };
        assert_eq!(numbers_in_typed_range(typed).collect::<Vec<_>>(), [0.0, 0.5, 1.0]);
    }

    #[test]
    fn owners_are_named_with_an_article_or_a_number() {
        let scene = StepScene::of_step(course::Step::Sphere);
        assert_eq!(owner_names(&scene, Owner::Object), ["the sphere"]);
        assert_eq!(owner_names(&scene, Owner::Light), ["the warm light", "the cool light"]);
        assert_eq!(owner_names(&scene, Owner::Scene), ["the scene"]);
        let named = StepScene::of_generated_scene("ada");
        assert_eq!(owner_names(&named, Owner::Object)[..2], ["ball 1", "the ground"]);
    }
}
