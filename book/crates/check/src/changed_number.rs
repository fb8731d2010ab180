use crate::comparison::{Budget, Comparison};
use crate::drawing::Drawing;
use course::{OwnScene, Owner, QUANTITIES, Quantity, Typed};

/// All single numbers of the scene, typed otherwise, that give the reader's picture in every
/// pixel, in words.
pub(crate) fn find_changed_numbers(
    comparison: &Comparison,
    drawing: &Drawing,
    budget: &Budget,
) -> Vec<String> {
    let mut pixels: Vec<_> = comparison.pixels().collect();
    let own = OwnScene::new(drawing.own.scene.clone());
    let mut changed = Drawing { own, ..*drawing };
    let mut words = vec![];
    for quantity in QUANTITIES {
        let Some(typed) = quantity.typed.filter(|typed| typed.since <= drawing.step) else {
            continue;
        };
        for (k, owner) in owner_names(drawing, quantity.owner).into_iter().enumerate() {
            for scalar in quantity.scalars {
                let old = scalar.get(&drawing.own, k);
                for new in typed_numbers(typed).filter(|new| *new != old) {
                    scalar.set(&mut changed.own, k, new);
                    if budget.all(&mut pixels, 1, |pixel| changed.bytes(&pixel.ray) == pixel.yours)
                    {
                        let [new, old] = [&changed.own, &drawing.own]
                            .map(|own| format_quantity(quantity, own, k));
                        words
                            .push(format!("{} of {owner} = {new} instead of {old}", quantity.name));
                    }
                }
                scalar.set(&mut changed.own, k, old);
            }
        }
    }
    words
}

/// The names of all that have a quantity.
pub(crate) fn owner_names(drawing: &Drawing, owner: Owner) -> Vec<String> {
    match owner {
        Owner::Object => drawing.object_names(),
        Owner::Light => drawing.light_names.map(str::to_owned).to_vec(),
        Owner::Scene | Owner::Camera => vec!["the scene".to_owned()],
    }
}

/// All numbers that somebody may have typed.
fn typed_numbers(
    Typed { range: [start, end], steps_per_unit, .. }: Typed,
) -> impl Iterator<Item = f64> {
    let numerators = start * steps_per_unit..=end * steps_per_unit;
    numerators.map(move |numerator| f64::from(numerator) / f64::from(steps_per_unit))
}

/// The quantity of owner k, such as (1, −2.5, 0); without brackets if it's a single number.
pub(crate) fn format_quantity(quantity: &Quantity, own: &OwnScene, k: usize) -> String {
    let numbers = quantity.scalars.iter().map(|scalar| scalar.get(own, k).to_string());
    let numbers: Vec<_> = numbers.collect();
    let text = numbers.join(", ").replace('-', "−");
    if numbers.len() == 1 { text } else { format!("({text})") }
}
