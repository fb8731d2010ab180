use super::{asked, picture};
use crate::live::{Knob, Live, vector};
use step02_sphere::{SPHERE, colour};

/// The picture of step 2, with a pixel to ask.
pub const STEP02: Live = Live {
    name: "step02_sphere",
    knobs: &[
        Knob { value: 370.0, ..asked::COLUMN },
        Knob { value: 140.0, ..asked::ROW },
        asked::COLUMNS,
    ],
    handles: &[asked::PIXEL],
    is_allowed: |values| asked::camera(values[2]).is_ok(),
    sight: |values| picture(&asked::seen(values[2]), |ray| colour(&SPHERE, ray)),
    numbers: |values| {
        let ray = asked::ray(values);
        let hit = SPHERE.intersect(&ray).first_hit();
        let mut numbers = asked::from_pixel(values, [&SPHERE].into_iter());
        numbers.extend(asked::met(hit.map(|t| ("the sphere", t)), &ray));
        let sum = colour(&SPHERE, &ray);
        numbers.push(("sum".into(), vector(&sum.to_array())));
        numbers.push(asked::bytes(&ray, |ray| colour(&SPHERE, ray)));
        numbers
    },
};
