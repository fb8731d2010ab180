use crate::aspect_ratio::{aspect_ratio_parameter, camera};
use crate::{Interactive, Output, Parameter, array};
use step01_rays::{Camera, direction_colour, render};

/// The picture of step 1, with its camera to set.
pub struct Rays(Camera);

impl Interactive for Rays {
    const NAME: &str = "step01_rays";

    fn parameters() -> Vec<Parameter> {
        vec![
            Parameter::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
            aspect_ratio_parameter(),
            Parameter::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0),
        ]
    }

    fn from_values(values: &[f64]) -> Self {
        let [degrees, choice, columns] = array(values);
        Self(camera(degrees, choice, columns))
    }

    fn draw(&self) -> Output {
        Output::Pixels(render(&self.0, 1, direction_colour))
    }
}
