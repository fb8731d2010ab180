use crate::camera_fit::fitted_camera;
use crate::comparison::{Comparison, Pixel, RayBudget};
use crate::drawing::{Drawing, bytes, colour};
use course::{OwnScene, Owner, QUANTITIES, Quantity, Step, Typed};
use step05_phong::{Ray, nearest};

/// How many pixels are asked of a number before all are.
const FIRST: usize = 32;

/// The most numbers of one quantity that are asked of all pixels.
const MOST_NUMBERS: usize = 8;

/// How many rays may be computed to try numbers in all pixels.
const RAYS: u32 = 4_000_000;

/// All single numbers of the scene, and all cameras, that give the reader's picture in every
/// pixel, in words.
pub(crate) fn find_changes(comparison: &Comparison) -> Vec<String> {
    let Some(drawing) = comparison.drawing else { return vec![] };
    let budget = RayBudget::new(RAYS);
    let holds = |(_, changed): &(String, Drawing)| {
        comparison.is_given_by(|pixel| changed.bytes(&comparison.ray(pixel)), &budget)
    };
    let numbers = changed_numbers(comparison, drawing).filter(holds);
    let mut words: Vec<_> = numbers.map(|(words, _)| words).collect();
    if let Some((camera_words, camera)) = fitted_camera(comparison) {
        let ray = |pixel: &Pixel| camera.ray(pixel.place.0.into(), pixel.place.1.into());
        if comparison.is_given_by(|pixel| drawing.bytes(&ray(pixel)), &budget) {
            words.extend(camera_words);
        }
    }
    words
}

/// Our drawing with one other number, and in words, tried in a few pixels.
fn changed_numbers(
    comparison: &Comparison,
    drawing: &Drawing,
) -> impl Iterator<Item = (String, Drawing)> {
    let quantities = QUANTITIES.iter().filter_map(|quantity| Some((quantity, quantity.typed?)));
    let quantities = quantities.filter(|(_, typed)| typed.since <= drawing.step);
    quantities.flat_map(move |(quantity, typed)| {
        let owners = 0..match quantity.owner {
            Owner::Object => drawing.scene.objects.len(),
            Owner::Light => drawing.scene.lights.len(),
            Owner::Scene | Owner::Camera => 1,
        };
        let owners = owners
            .filter(move |k| may_cause_wrong_pixels(quantity.owner, typed.since, *k, comparison));
        owners.flat_map(move |k| fitting_numbers(comparison, drawing, quantity, typed, k))
    })
}

/// Whether all wrong pixels are where a quantity of owner `k` can change one.
fn may_cause_wrong_pixels(owner: Owner, since: Step, k: usize, comparison: &Comparison) -> bool {
    comparison.wrong_pixels().iter().all(|pixel| match owner {
        Owner::Object => since == Step::Sphere || pixel.object() == Some(k),
        _ => !pixel.is_sky(),
    })
}

/// The other numbers of one quantity that give some of the wrong pixels, the nearest first.
fn fitting_numbers(
    comparison: &Comparison,
    drawing: &Drawing,
    quantity: &Quantity,
    typed: Typed,
    k: usize,
) -> Vec<(String, Drawing)> {
    let wrong = comparison.wrong_pixels();
    let some = wrong.iter().step_by(wrong.len().div_ceil(FIRST).max(1));
    let is_shape = quantity.owner == Owner::Object && typed.since == Step::Sphere;
    let some: Vec<_> = some
        .map(|pixel| {
            let ray = comparison.ray(pixel);
            (ray, pixel.yours, is_shape.then(|| rest_of_ray(drawing, k, &ray)))
        })
        .collect();
    let mut own = OwnScene::new(drawing.scene.clone());
    let old = (quantity.get)(&own, k);
    let mut fits = vec![];
    for new in all_with_one_number_changed(old, quantity.numbers.len(), typed) {
        (quantity.set)(&mut own, k, new);
        let is_behind = |ray: &Ray, rest_t: f64| {
            let hit = own.scene.objects[k].sphere.intersect(ray).first_hit();
            hit.is_none_or(|t| rest_t < t)
        };
        let is_given = |(ray, yours, rest): &_| match rest {
            Some((t, bytes)) if is_behind(ray, *t) => bytes == yours,
            _ => bytes(colour(drawing.step, &own.scene, ray)) == *yours,
        };
        if some.iter().all(is_given) {
            fits.push(new);
        }
    }
    let distance = |new: &[f64; 3]| (0..3).map(|k| (new[k] - old[k]).abs()).sum();
    fits.sort_by(|a, b| f64::total_cmp(&distance(a), &distance(b)));
    let owner = match quantity.owner {
        Owner::Object => drawing.object_name(k),
        Owner::Light => drawing.light_names[k].to_owned(),
        Owner::Scene | Owner::Camera => "the scene".to_owned(),
    };
    let change = |new: [f64; 3]| {
        (quantity.set)(&mut own, k, new);
        let [new, old] = [new, old].map(|one| format_numbers(&one[..quantity.numbers.len()]));
        let words = format!("with {} of {owner} = {new} instead of {old}", quantity.name);
        (words, Drawing { scene: own.scene.clone(), ..drawing.clone() })
    };
    fits.into_iter().take(MOST_NUMBERS).map(change).collect()
}

/// The t and the bytes of what a ray sees without object k, which is most of what is seen with
/// it elsewhere.
fn rest_of_ray(drawing: &Drawing, k: usize, ray: &Ray) -> (f64, [u8; 3]) {
    let mut rest = drawing.clone();
    rest.scene.objects.remove(k);
    let t = nearest(&rest.scene.objects, ray).map_or(f64::INFINITY, |hit| hit.t);
    (t, rest.bytes(ray))
}

/// One number or three, one of them changed to another that somebody may have typed.
fn all_with_one_number_changed(
    old: [f64; 3],
    count: usize,
    Typed { since, range: [start, end], steps_per_unit, .. }: Typed,
) -> impl Iterator<Item = [f64; 3]> {
    let values = (start * steps_per_unit..=end * steps_per_unit)
        .map(move |value| f64::from(value) / f64::from(steps_per_unit));
    (0..count).flat_map(move |k| {
        // A radius of 0 is a sphere that is missing.
        let is_radius = since == Step::Sphere && count == 1;
        let is_other = move |value: &f64| *value != old[k] && !(is_radius && *value == 0.0);
        values.clone().filter(is_other).map(move |value| {
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
