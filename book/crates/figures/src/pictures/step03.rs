use super::pixel_trace::trace_pixel;
use crate::{Interactive, Numbers, Output, Probe};
use step03_nearest::{OBJECTS, colour, render};

/// The picture of step 3, with a probe.
pub struct FlatSpheres(Probe);

impl Interactive for FlatSpheres {
    const NAME: &str = "step03_nearest";
    const PROBE: Option<[f64; 2]> = Some([195.0, 237.0]);

    fn from_values(values: &[f64]) -> Self {
        Self(Probe::split_values(values).0)
    }

    fn draw(&self) -> Output {
        Output::Pixels(render(&self.0.camera(), 1, |ray| colour(&OBJECTS, ray)))
    }

    fn numbers(&self) -> Numbers {
        trace_pixel(&self.0, &OBJECTS, |ray| colour(&OBJECTS, ray))
    }
}
