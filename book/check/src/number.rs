use crate::place::{Place, place};
use crate::quantity::{Owner, QUANTITIES, Quantity};
use crate::scene::{LIGHTS, Scene, object, pixel, scene};
use crate::{Step, camera};
use image::RgbImage;
use step01_rays::Ray;

/// A sentence that gives a picture in every pixel, and where to go back to.
pub(crate) struct Found {
    /// The whole sentence.
    pub text: String,
    /// Where the number stands.
    pub place: Option<Place>,
}

/// The one number of a step's scene with which our own step draws this very picture.
pub(crate) fn number(
    step: Step,
    yours: &RgbImage,
    ours: &RgbImage,
) -> Option<Found> {
    let order = scattered(yours, ours);
    let is_it = |scene: &Scene| {
        let pixel = pixel(step, scene);
        order.iter().all(|(ray, yours)| pixel(ray) == *yours)
    };
    let mut scene = scene(step);
    for quantity in QUANTITIES.iter().filter(|one| one.since <= step) {
        let owners = owners(quantity, step);
        let file = match step {
            Step::Sphere => "step02_sphere/picture.rs",
            _ => quantity.file,
        };
        for (k, name) in owners.iter().enumerate() {
            let old = (quantity.get)(&scene, k);
            let mut fits = changed(quantity, old).into_iter().filter(|new| {
                (quantity.set)(&mut scene, k, *new);
                is_it(&scene)
            });
            if let Some(new) = fits.next() {
                let is = if fits.next().is_none() { "is" } else { "may be" };
                let at = if quantity.name.is_empty() { "at " } else { "" };
                let [new, old] = [new, old].map(|one| told(&one[..quantity.count]));
                let text = format!(
                    "{name} {is} {at}{new} in your picture; it should be {at}{old}.\n"
                );
                return Some(Found { text, place: place(file) });
            }
            drop(fits);
            (quantity.set)(&mut scene, k, old);
        }
    }
    None
}

/// What a quantity of each of its owners is called.
fn owners(quantity: &Quantity, step: Step) -> Vec<String> {
    let names: Vec<_> = match quantity.owner {
        Owner::Object => {
            let count = scene(step).objects.len();
            (0..count).map(|k| object(step, k)).collect()
        }
        Owner::Light => LIGHTS.map(String::from).into(),
        Owner::Scene => vec!["the scene".to_string()],
    };
    names.iter().map(|name| format!("{}{name}", quantity.name)).collect()
}

/// A quantity with one of its numbers changed, the nearest first.
fn changed(quantity: &Quantity, old: [f64; 3]) -> Vec<[f64; 3]> {
    let (start, end, parts) = quantity.range;
    let values = start * parts..=end * parts;
    let mut all = vec![];
    for k in 0..quantity.count {
        let mut values: Vec<_> = values
            .clone()
            .map(|value| f64::from(value) / f64::from(parts))
            .collect();
        let far = |value: &f64| (value - old[k]).abs();
        values.sort_by(|a, b| far(a).total_cmp(&far(b)));
        all.extend(values.into_iter().map(|value| {
            let mut new = if quantity.count == 1 { [value; 3] } else { old };
            new[k] = value;
            new
        }));
    }
    all.retain(|new| *new != old);
    all
}

/// (1, −2.5, 0), or the number alone.
fn told(numbers: &[f64]) -> String {
    let all: Vec<_> = numbers.iter().map(f64::to_string).collect();
    let all = all.join(", ").replace('-', "−");
    if numbers.len() == 1 { all } else { format!("({all})") }
}

/// The ray and the pixel of each place, in an order in which a wrong guess is soon found
/// out: those that differ first, scattered.
fn scattered(yours: &RgbImage, ours: &RgbImage) -> Vec<(Ray, [u8; 3])> {
    let (columns, rows) = yours.dimensions();
    let camera = camera(columns, rows);
    let count = u64::from(columns) * u64::from(rows);
    // 7919 is a prime that divides no number of pixels.
    let places = (0..count).map(|k| k * 7919 % count);
    let places = places.map(|k| {
        ((k % u64::from(columns)) as u32, (k / u64::from(columns)) as u32)
    });
    let (mut order, others): (Vec<_>, Vec<_>) =
        places.partition(|&(i, j)| yours.get_pixel(i, j) != ours.get_pixel(i, j));
    order.extend(others);
    let pixels = order
        .into_iter()
        .map(|(i, j)| (camera.ray(i.into(), j.into()), yours.get_pixel(i, j).0));
    pixels.collect()
}
