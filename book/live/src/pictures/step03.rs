use super::numbers::numbers;
use super::pixel;
use crate::figures::from_above;
use crate::live::{Live, Sight};
use step03_nearest::{OBJECTS, colour, render};

/// The picture of step 3, with a pixel to ask.
pub fn picture() -> Live {
    Live {
        knobs: pixel::knobs(470.0, 120.0),
        handles: vec![pixel::cross()],
        numbers: |values| {
            let colour = |ray: &_| colour(&OBJECTS, ray);
            numbers(values, &OBJECTS, |_| None, colour)
        },
        beside: Some(("from-above", from_above)),
        ..Live::new("step03_nearest", |values| {
            let camera = pixel::camera(values);
            Sight::Picture(render(&camera, 1, |ray| colour(&OBJECTS, ray)))
        })
    }
}
