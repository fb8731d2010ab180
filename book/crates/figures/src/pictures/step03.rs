use super::pixel_trace::trace_pixel;
use crate::figures::draw_scene_from_above;
use crate::probe::Probe;
use crate::{Companion, Live, Numbers, Output};
use step03_nearest::{OBJECTS, colour, render};

/// The picture of step 3, with a probe.
pub fn picture() -> Live {
    Live {
        parameters: Probe::parameters(470.0, 120.0),
        handles: vec![Probe::handle()],
        numbers: |values| {
            let (probe, _) = Probe::split_values(values);
            let colour = |ray: &_| colour(&OBJECTS, ray);
            trace_pixel(&probe, &OBJECTS, |_| Numbers::new(), colour)
        },
        companion: Some(Companion { name: "from-above", draw: draw_scene_from_above }),
        ..Live::new("step03_nearest", |values| {
            let (probe, _) = Probe::split_values(values);
            let colour = |ray: &_| colour(&OBJECTS, ray);
            Output::Picture(render(&probe.camera(), 1, colour))
        })
    }
}
