//! The parameters of the reader's own scene: the columns, then the numbers of the camera, of
//! the ambient light, of the spheres and of the lights, and the switches among them. Three
//! spheres and a light are switched off at first, and so are shadows and mirrors.

use crate::Parameter;
use crate::probe::columns_parameter;
use course::examples::mirror::mirrors;
use course::examples::own_scene::{ball, lamp};
use course::{OwnScene, Owner, QUANTITIES, Quantity};
use std::iter::zip;
use std::sync::LazyLock;
use step05_phong::{OBJECTS, scene};

/// What a parameter sets.
#[derive(Clone, Copy)]
pub enum Target {
    /// The columns of the picture.
    Columns,
    /// Whether there are shadows and mirrors.
    Mirrors,
    /// Whether the scene has the object or light of this number.
    Presence(Owner, usize),
    /// The number of this place in a quantity of an owner.
    Number(&'static Quantity, usize, usize),
}

/// All parameters, and what each sets.
pub static PARAMETERS: LazyLock<Vec<(Target, Parameter)>> = LazyLock::new(|| {
    let own = largest_scene();
    let switch = |words, group, is_on| Parameter { group, ..Parameter::switch(words, is_on) };
    // A picture that is kept is drawn large.
    let columns = Parameter { range: [2.0, 3840.0], ..columns_parameter() };
    let mut parameters = vec![(Target::Columns, columns)];
    parameters.extend(numbers(&own, Owner::Camera, 0, "camera"));
    parameters.extend(numbers(&own, Owner::Scene, 0, "ambient light"));
    let mirrors = switch("shadows and mirrors", "the way back", false);
    parameters.push((Target::Mirrors, mirrors));
    for (k, object) in own.scene.objects.iter().enumerate() {
        let presence = switch("in the scene", object.name, k < OBJECTS.len());
        parameters.push((Target::Presence(Owner::Object, k), presence));
        parameters.extend(numbers(&own, Owner::Object, k, object.name));
    }
    for (k, name) in ["warm light", "cool light", "third light"].into_iter().enumerate() {
        parameters.push((Target::Presence(Owner::Light, k), switch("on", name, k < 2)));
        parameters.extend(numbers(&own, Owner::Light, k, name));
    }
    parameters
});

/// The parameters for the numbers of the owner k.
fn numbers(
    own: &OwnScene,
    owner: Owner,
    k: usize,
    group: &'static str,
) -> impl Iterator<Item = (Target, Parameter)> {
    let quantities = QUANTITIES.iter().filter(move |quantity| quantity.owner == owner);
    quantities.flat_map(move |quantity| {
        let defaults = (quantity.get)(own, k);
        let ground_ranges = quantity.ground_ranges.filter(|_| group == "ground");
        quantity.numbers.iter().enumerate().map(move |(place, number)| {
            let course::Number { symbol, words, unit, range, steps_per_unit } = *number;
            let range = ground_ranges.map_or(range, |ranges| ranges[place]);
            let names = [symbol, words, unit];
            let parameter = Parameter::new(names, defaults[place], range, steps_per_unit);
            let mut parameter = Parameter { group, ..parameter };
            if quantity.needs_mirrors {
                parameter.has_control = |_, values| own_scene(values).has_mirrors;
            }
            (Target::Number(quantity, k, place), parameter)
        })
    })
}

/// The scene of these values of all parameters.
pub fn own_scene(values: &[f64]) -> OwnScene {
    let mut own = largest_scene();
    let mut absent = vec![];
    for ((target, _), &value) in zip(&*PARAMETERS, values) {
        match *target {
            Target::Mirrors => own.has_mirrors = value == 1.0,
            Target::Presence(owner, k) if value == 0.0 => absent.push((owner, k)),
            Target::Columns | Target::Presence(..) => {}
            Target::Number(quantity, k, place) => {
                let mut numbers = match quantity.numbers {
                    [_] => [value; 3],
                    _ => (quantity.get)(&own, k),
                };
                numbers[place] = value;
                (quantity.set)(&mut own, k, numbers);
            }
        }
    }
    // From the last, so that the others keep their numbers.
    for (owner, k) in absent.into_iter().rev() {
        if owner == Owner::Object {
            own.scene.objects.remove(k);
            own.mirror_parts.remove(k);
        } else {
            own.scene.lights.remove(k);
        }
    }
    own
}

/// The scene of step 5 with all that can be switched on.
fn largest_scene() -> OwnScene {
    let mut scene = scene();
    scene.objects.extend([
        ball("tenth sphere", [1.25, -1.1, -5.0], 0.35, [0.45, 0.2, 0.6], 0.8, 80),
        ball("eleventh sphere", [-1.2, 1.6, -7.0], 0.4, [0.1, 0.3, 0.75], 0.6, 60),
        ball("twelfth sphere", [1.6, 1.7, -8.0], 0.45, [0.85, 0.15, 0.35], 0.3, 20),
    ]);
    scene.lights.push(lamp([0.3, 1.5, -5.0], [0.9, 0.3, 0.6], [1.0, 0.6, 0.8], [0.6, 0.0, 0.1]));
    let mirror_parts = mirrors().objects.into_iter().map(|object| object.material.k);
    let mirror_parts = mirror_parts.chain([0.5, 0.3, 0.1]).collect();
    OwnScene { mirror_parts, ..OwnScene::new(scene) }
}
