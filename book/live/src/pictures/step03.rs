use super::{asked, picture};
use crate::figures::from_above;
use crate::live::{Live, vector};
use step03_nearest::{Hit, Object, colour, nearest, objects};

/// The picture of step 3, with a pixel to ask.
pub const STEP03: Live = Live {
    name: "step03_nearest",
    knobs: &[asked::COLUMN, asked::ROW, asked::COLUMNS],
    handles: &[asked::PIXEL],
    is_allowed: |values| asked::camera(values[2]).is_ok(),
    sight: |values| {
        let objects = objects();
        picture(&asked::seen(values[2]), |ray| colour(&objects, ray))
    },
    numbers: |values| {
        let (objects, ray) = (objects(), asked::ray(values));
        let spheres = objects.iter().map(|object| &object.sphere);
        let mut numbers = asked::from_pixel(values, spheres);
        let hit = nearest(&objects, &ray);
        numbers.extend(asked::met(hit.map(|hit| named(&objects, hit)), &ray));
        let sum = colour(&objects, &ray);
        numbers.push(("sum".into(), vector(&sum.to_array())));
        numbers.push(asked::bytes(&ray, |ray| colour(&objects, ray)));
        numbers
    },
    beside: Some(("from-above", from_above)),
};

/// What the chapters call the objects of the scene, in their order.
pub const OBJECTS: [&str; 9] = [
    "red", "ground", "golden", "blue", "green", "teal", "white", "salmon", "cream",
];

/// What the object of a hit is called, and the t of it.
pub fn named<M>(objects: &[Object<M>], hit: Hit<M>) -> (&'static str, f64) {
    let mut named = objects.iter().zip(OBJECTS);
    let known = named.find(|(object, _)| std::ptr::eq(*object, hit.object));
    (known.map_or("", |(_, name)| name), hit.t)
}
