use super::pixel_trace::trace_pixel;
use crate::parameter::array;
use crate::probe::{Probe, place_of_point, point_at_place};
use crate::{Handle, Live, Numbers, Output, Parameter};
use step02_sphere::{SPHERE, Sphere, colour, render};
use step03_nearest::Object;

/// The probe and the sphere of these values; its z stays.
fn probe_and_sphere(values: &[f64]) -> (Probe, Sphere) {
    let (probe, others) = Probe::split_values(values);
    let [x, y, radius] = array(others);
    let centre = SPHERE.centre.with_x(x).with_y(y);
    (probe, Sphere { centre, radius })
}

/// The picture of step 2: its sphere to drag and to blow up, and a probe.
pub fn picture() -> Live {
    let Sphere { centre, radius } = SPHERE;
    let mut parameters = Probe::parameters(370.0, 140.0);
    parameters.extend([
        Parameter::coordinate(centre.x, [-2.8, 2.8], 20.0),
        Parameter::coordinate(centre.y, [-1.6, 1.6], 20.0),
        Parameter::new(["r", "radius", ""], radius, [0.1, 6.0], 10.0),
    ]);
    let centre = Handle::new(
        "the centre of the sphere",
        [3, 4],
        |_, values| {
            let (_, sphere) = probe_and_sphere(values);
            place_of_point(&crate::camera(), sphere.centre)
        },
        |handle, values, place| {
            point_at_place(&crate::camera(), place, SPHERE.centre.z)
                .unwrap_or_else(|| handle.coordinates(values))
        },
    );
    Live {
        parameters,
        handles: vec![Probe::handle(), centre],
        numbers: |values| {
            let (probe, sphere) = probe_and_sphere(values);
            let object = Object { name: "the sphere", sphere, material: () };
            let colour = |ray: &_| colour(&sphere, ray);
            trace_pixel(&probe, &[object], |_| Numbers::new(), colour)
        },
        ..Live::new("step02_sphere", |values| {
            let (probe, sphere) = probe_and_sphere(values);
            let colour = |ray: &_| colour(&sphere, ray);
            Output::Picture(render(&probe.camera(), 1, colour))
        })
    }
}
