use crate::place::{Place, place};
use crate::quantity::{Quantity, quantities};
use crate::scenes::Scenes;
use crate::{Step, camera};
use image::RgbImage;

/// What gives a picture in every pixel: a sentence, and where to go back to.
pub(crate) struct Found {
    /// The whole sentence.
    pub text: String,
    /// Where the number stands.
    pub place: Option<Place>,
}

/// The one number of a step's scene, or the two that have changed places, with which our
/// own step draws this very picture.
pub(crate) fn number(
    step: Step,
    yours: &RgbImage,
    ours: &RgbImage,
) -> Option<Found> {
    let right = Scenes::right();
    let search = Search::new(step, yours, ours);
    let all = quantities(step, &right);
    let mut scenes = right.clone();
    for quantity in &all {
        let old = (quantity.get)(&right);
        for new in changed(quantity, &old) {
            (quantity.set)(&mut scenes, &new);
            if search.is_it(&scenes) {
                let Quantity { subject, at, .. } = quantity;
                let (new, old) = (vector(&new), vector(&old));
                let text = format!(
                    "{subject} is {at}{new} in your picture; it should be {at}{old}.\n"
                );
                return Some(Found { text, place: place(quantity.file) });
            }
        }
        (quantity.set)(&mut scenes, &old);
    }
    for (k, one) in all.iter().enumerate() {
        for other in all[k + 1..].iter().filter(|other| other.sort == one.sort) {
            let (a, b) = ((one.get)(&right), (other.get)(&right));
            (one.set)(&mut scenes, &b);
            (other.set)(&mut scenes, &a);
            if search.is_it(&scenes) {
                let (one, other, file) = (&one.subject, &other.subject, one.file);
                let text = format!("{one} and {other} have changed places.\n");
                return Some(Found { text, place: place(file) });
            }
            (one.set)(&mut scenes, &a);
            (other.set)(&mut scenes, &b);
        }
    }
    None
}

/// A quantity with one of its numbers changed, the nearest first, or with two of them
/// swapped.
fn changed(quantity: &Quantity, old: &[f64]) -> Vec<Vec<f64>> {
    let mut all = vec![];
    for k in 0..old.len() {
        let mut values = quantity.values.clone();
        let far = |value: &f64| (value - old[k]).abs();
        values.sort_by(|a, b| far(a).total_cmp(&far(b)));
        all.extend(values.into_iter().map(|value| {
            let mut new = old.to_vec();
            new[k] = value;
            new
        }));
        all.extend((0..k).map(|l| {
            let mut new = old.to_vec();
            new.swap(k, l);
            new
        }));
    }
    all.retain(|new| new != old);
    all
}

/// (1, −2.5, 0), or the number alone.
pub(crate) fn vector(numbers: &[f64]) -> String {
    let all: Vec<_> = numbers.iter().map(|number| number.to_string()).collect();
    let all = all.join(", ").replace('-', "−");
    if numbers.len() == 1 { all } else { format!("({all})") }
}

/// The pixels of a picture, in an order in which a wrong guess is soon found out.
struct Search<'a> {
    step: Step,
    yours: &'a RgbImage,
    order: Vec<(u32, u32)>,
}

impl<'a> Search<'a> {
    fn new(step: Step, yours: &'a RgbImage, ours: &RgbImage) -> Self {
        let (columns, rows) = yours.dimensions();
        let count = u64::from(columns) * u64::from(rows);
        // All pixels, scattered; 7919 is a prime that divides no number of them.
        let places = (0..count).map(|k| k * 7919 % count);
        let places = places.map(|k| {
            ((k % u64::from(columns)) as u32, (k / u64::from(columns)) as u32)
        });
        let differs =
            |&(i, j): &(u32, u32)| yours.get_pixel(i, j) != ours.get_pixel(i, j);
        let (mut order, others): (Vec<_>, Vec<_>) = places.partition(differs);
        order.extend(others);
        Self { step, yours, order }
    }

    /// Whether the step draws the picture of these scenes.
    fn is_it(&self, scenes: &Scenes) -> bool {
        let camera = camera(self.yours.width(), self.yours.height());
        self.order.iter().all(|&(i, j)| {
            let ray = camera.ray(i.into(), j.into());
            scenes.pixel(self.step, &ray) == self.yours.get_pixel(i, j).0
        })
    }
}
