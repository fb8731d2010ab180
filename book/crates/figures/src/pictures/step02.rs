//! The picture of step 2, with a sphere that the reader can change.

use super::pixel_trace::trace_pixel;
use crate::probe::{draw_picture, probed_picture};
use crate::{Figure, Handle, Parameter, ParameterId, ParameterValues, PointId};
use step02_sphere::{SPHERE, Sphere, colour};
use step03_nearest::Object;

const CENTRE: PointId = PointId("the centre of the sphere");
const RADIUS: ParameterId = ParameterId::new("radius");

/// The picture of step 2, with a probe. The sphere can be dragged and resized.
pub fn figure() -> Figure {
    let Sphere { centre, radius } = SPHERE;
    let [x, y] = Parameter::point(CENTRE, [centre.x, centre.y], [[-2.8, 2.8], [-1.6, 1.6]], 20.0);
    let radius = Parameter::number(RADIUS, "radius", radius, [0.1, 6.0], 10.0).with_symbol("r");
    let mut figure =
        probed_picture("step02_sphere", [300.0, 150.0], [x, y, radius], |values, columns| {
            let sphere = sphere(values);
            draw_picture(columns, |ray| colour(&sphere, ray))
        });
    let centre = |values: &ParameterValues| Some((course::camera(), sphere(values).centre));
    figure.handles.push(Handle::of_world_xy_in_picture(
        CENTRE.0,
        [CENTRE.x(), CENTRE.y()],
        0.0,
        centre,
    ));
    figure.row_count = 1;
    figure.readouts = |values| {
        let sphere = sphere(values);
        let object = Object { name: "sphere", sphere, material: () };
        trace_pixel(values, &[object], |ray| colour(&sphere, ray))
    };
    figure
}

fn sphere(values: &ParameterValues) -> Sphere {
    let centre = values.point(CENTRE).extend(SPHERE.centre.z);
    Sphere { centre, radius: values[RADIUS] }
}
