use super::numbers::numbers;
use super::pixel::{self, place, point};
use crate::live::{Handle, Knob, Live, Sight};
use step02_sphere::{SPHERE, Sphere, colour, render};
use step03_nearest::Object;

/// The sphere of these values; it stays as far ahead as it is.
fn sphere(values: &[f64]) -> Sphere {
    let mut sphere = SPHERE;
    (sphere.centre.x, sphere.centre.y) = (values[3], values[4]);
    Sphere { radius: values[5], ..sphere }
}

/// The picture of step 2: its sphere to drag and to blow up, and a pixel to ask.
pub fn picture() -> Live {
    let Sphere { centre, radius } = SPHERE;
    let mut knobs = pixel::knobs(370.0, 140.0);
    knobs.extend([
        Knob::turned(centre.x, [-2.8, 2.8], 20.0),
        Knob::turned(centre.y, [-1.6, 1.6], 20.0),
        Knob::new(["r", "radius", ""], radius, [0.1, 6.0], 10.0),
    ]);
    let centre = Handle::new(
        "the centre of the sphere",
        [3, 4],
        |_, values| place(&crate::camera(), sphere(values).centre),
        |_, _, to| point(&crate::camera(), to, SPHERE.centre.z),
    );
    Live {
        knobs,
        handles: vec![pixel::cross(), centre],
        numbers: |values| {
            let sphere = sphere(values);
            let object = Object { name: "the sphere", sphere, material: () };
            let colour = |ray: &_| colour(&sphere, ray);
            numbers(values, &[object], |_| None, colour)
        },
        ..Live::new("step02_sphere", |values| {
            let sphere = sphere(values);
            let camera = pixel::camera(values);
            Sight::Picture(render(&camera, 1, |ray| colour(&sphere, ray)))
        })
    }
}
