use crate::comparison::{Comparison, Pixel, RayBudget};
use crate::drawing::{Drawing, Scene, bytes, colour};
use course::{OwnScene, Owner, QUANTITIES, Step, Typed};

/// All single numbers of the scene, typed otherwise, that give the reader's picture in every
/// pixel, in words; of each quantity those next to ours come first.
pub(crate) fn find_changed_numbers(
    comparison: &Comparison,
    drawing: &Drawing,
    budget: &RayBudget,
) -> Vec<String> {
    let mut pixels: Vec<&Pixel> = comparison.pixels.iter().collect();
    let mut own = OwnScene::new(drawing.scene.clone());
    let mut words = vec![];
    for quantity in QUANTITIES {
        let Some(typed) = quantity.typed.filter(|typed| typed.since <= drawing.step) else {
            continue;
        };
        for (k, owner) in owner_names(drawing, quantity.owner).into_iter().enumerate() {
            if !may_cause_wrong_pixels(quantity.owner, typed.since, k, comparison) {
                continue;
            }
            let (old, count) = ((quantity.get)(&own, k), quantity.numbers.len());
            for new in all_with_one_number_changed(old, count, typed) {
                (quantity.set)(&mut own, k, new);
                let is_given = |pixel: &&Pixel| match quantity.owner {
                    Owner::Object if is_of_others(pixel, k, &own.scene) => !pixel.is_wrong(),
                    _ => bytes(colour(drawing.step, &own.scene, &pixel.ray)) == pixel.yours,
                };
                if budget.all(&mut pixels, 1, is_given) {
                    let [new, old] = [new, old].map(|one| format_numbers(&one[..count]));
                    let name = quantity.name;
                    words.push(format!("with {name} of {owner} = {new} instead of {old}"));
                }
            }
            (quantity.set)(&mut own, k, old);
        }
    }
    words
}

/// The names of all that have a quantity.
fn owner_names(drawing: &Drawing, owner: Owner) -> Vec<String> {
    match owner {
        Owner::Object => (0..drawing.scene.objects.len()).map(|k| drawing.object_name(k)).collect(),
        Owner::Light => drawing.light_names.map(str::to_owned).to_vec(),
        Owner::Scene | Owner::Camera => vec!["the scene".to_owned()],
    }
}

/// Whether ours doesn't show object `k`, and it isn't seen in this scene either.
fn is_of_others(pixel: &Pixel, k: usize, scene: &Scene) -> bool {
    let is_before = |t| pixel.hit.is_none_or(|hit| t < hit.t);
    let hit = || scene.objects[k].sphere.intersect(&pixel.ray).first_hit();
    pixel.object() != Some(k) && !hit().is_some_and(is_before)
}

/// Whether all wrong pixels are where a quantity of owner `k` can change one.
fn may_cause_wrong_pixels(owner: Owner, since: Step, k: usize, comparison: &Comparison) -> bool {
    comparison.wrong_pixels().iter().all(|pixel| match owner {
        Owner::Object => since == Step::Sphere || pixel.object() == Some(k),
        _ => !pixel.is_sky(),
    })
}

/// One number or three, one of them changed to another that somebody may have typed.
fn all_with_one_number_changed(
    old: [f64; 3],
    count: usize,
    Typed { since, range: [start, end], steps_per_unit, .. }: Typed,
) -> impl Iterator<Item = [f64; 3]> {
    // A radius of 0 is a sphere that is missing.
    let is_radius = since == Step::Sphere && count == 1;
    (0..count).flat_map(move |k| {
        let values = (start * steps_per_unit..=end * steps_per_unit)
            .map(|value| f64::from(value) / f64::from(steps_per_unit))
            .filter(|value| *value != old[k] && !(is_radius && *value == 0.0));
        let mut values: Vec<_> = values.collect();
        values.sort_by(|a, b| (a - old[k]).abs().total_cmp(&(b - old[k]).abs()));
        values.into_iter().map(move |value| {
            let mut new = if count == 1 { [value; 3] } else { old };
            new[k] = value;
            new
        })
    })
}

/// (1, −2.5, 0), or the number alone.
fn format_numbers(numbers: &[f64]) -> String {
    let all: Vec<_> = numbers.iter().map(f64::to_string).collect();
    let all = all.join(", ").replace('-', "−");
    if numbers.len() == 1 { all } else { format!("({all})") }
}
