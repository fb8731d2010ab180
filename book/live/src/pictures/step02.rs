use super::{asked, chain, picture};
use crate::live::{Handle, Knob, Live, vector};
use glam::dvec3;
use step02_sphere::{SPHERE, Sphere, colour};

/// The picture of step 2: its sphere to drag and to blow up, and a pixel to ask.
pub const STEP02: Live = Live {
    name: "step02_sphere",
    knobs: &[
        Knob { value: 370.0, ..asked::COLUMN },
        Knob { value: 140.0, ..asked::ROW },
        asked::COLUMNS,
        Knob::new(["x₀", "of the centre", ""], SPHERE.centre.x, [-2.8, 2.8], 20.0),
        Knob::new(["y₀", "of the centre", ""], SPHERE.centre.y, [-1.6, 1.6], 20.0),
        Knob::new(["r", "radius", ""], SPHERE.radius, [0.1, 6.0], 10.0),
    ],
    handles: &[
        asked::PIXEL,
        Handle::new(
            "the centre of the sphere",
            [3, 4],
            |values| asked::place(sphere(values).centre),
            |values, to| {
                let centre = asked::point(to, -SPHERE.centre.z);
                values[3..5].copy_from_slice(&centre.truncate().to_array());
            },
        ),
    ],
    is_allowed: |values| asked::camera(values[2]).is_ok(),
    sight: |values| {
        let sphere = sphere(values);
        picture(&asked::seen(values[2]), |ray| colour(&sphere, ray))
    },
    numbers: |values| {
        let (sphere, ray) = (sphere(values), asked::ray(values));
        let hit = sphere.intersect(&ray).first_hit();
        let mut numbers = chain::from_pixel(values, [&sphere].into_iter());
        numbers.extend(chain::met(hit.map(|t| ("the sphere", t)), &ray));
        let sum = colour(&sphere, &ray);
        numbers.push(("sum".into(), vector(&sum.to_array())));
        numbers.push(chain::bytes(&ray, |ray| colour(&sphere, ray)));
        numbers
    },
    beside: None,
};

/// The sphere of these values; it stays as far ahead as it is.
fn sphere(values: &[f64]) -> Sphere {
    let centre = dvec3(values[3], values[4], SPHERE.centre.z);
    Sphere { centre, radius: values[5] }
}
