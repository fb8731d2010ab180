use super::pixel_trace::trace_pixel;
use crate::probe::{draw_picture, probed_picture};
use crate::{Figure, Handle, Parameter, array};
use step02_sphere::{SPHERE, Sphere, colour};
use step03_nearest::Object;

/// The picture of step 2: its sphere to drag and to blow up, and a probe.
pub fn figure() -> Figure {
    let Sphere { centre, radius } = SPHERE;
    let [x, y] = Parameter::point([centre.x, centre.y], [[-2.8, 2.8], [-1.6, 1.6]], 20.0);
    let parameters = vec![x, y, Parameter::new(["r", "radius", ""], radius, [0.1, 6.0], 10.0)];
    let mut figure = probed_picture("step02_sphere", [300.0, 150.0], parameters, |values| {
        let sphere = sphere(values);
        draw_picture(values, |ray| colour(&sphere, ray))
    });
    let centre = |values: &[f64]| Some((course::camera(), sphere(values).centre));
    figure.handles.push(Handle::in_picture("the centre of the sphere", 3, 0.0, centre));
    figure.numbers = |values| {
        let sphere = sphere(values);
        let object = Object { name: "sphere", sphere, material: () };
        trace_pixel(values, &[object], |ray| colour(&sphere, ray))
    };
    figure
}

fn sphere(values: &[f64]) -> Sphere {
    let [x, y, radius] = array(&values[3..]);
    Sphere { centre: SPHERE.centre.with_x(x).with_y(y), radius }
}
