use super::pixel_trace::trace_pixel;
use crate::{Handle, Interactive, Numbers, Output, Parameter, Probe, array};
use step02_sphere::{SPHERE, Sphere, colour, render};
use step03_nearest::Object;

/// The picture of step 2: its sphere to drag and to blow up, and a probe.
pub struct OneSphere {
    probe: Probe,
    sphere: Sphere,
}

impl Interactive for OneSphere {
    const NAME: &str = "step02_sphere";
    const PROBE: Option<[f64; 2]> = Some([300.0, 150.0]);

    fn parameters() -> Vec<Parameter> {
        let Sphere { centre, radius } = SPHERE;
        let [x, y] = Parameter::point([centre.x, centre.y], [[-2.8, 2.8], [-1.6, 1.6]], 20.0);
        vec![x, y, Parameter::new(["r", "radius", ""], radius, [0.1, 6.0], 10.0)]
    }

    fn from_values(values: &[f64]) -> Self {
        let (probe, others) = Probe::split_values(values);
        let [x, y, radius] = array(others);
        let centre = SPHERE.centre.with_x(x).with_y(y);
        Self { probe, sphere: Sphere { centre, radius } }
    }

    fn handles() -> Vec<Handle> {
        let centre = |picture: &Self| Some((course::camera(), picture.sphere.centre));
        vec![Self::handle_in_picture("the centre of the sphere", 3, 0.0, centre)]
    }

    fn draw(&self) -> Output {
        Output::Pixels(render(&self.probe.camera(), 1, |ray| colour(&self.sphere, ray)))
    }

    fn numbers(&self) -> Numbers {
        let object = Object { name: "sphere", sphere: self.sphere, material: () };
        trace_pixel(&self.probe, &[object], |ray| colour(&self.sphere, ray))
    }
}
