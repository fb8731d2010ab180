use crate::aspect_ratio::{aspect_ratio_parameter, camera};
use crate::{Figure, Output, Parameter, array};
use step01_rays::{direction_colour, render};

/// The picture of step 1, with its camera to set.
pub fn figure() -> Figure {
    let parameters = vec![
        Parameter::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
        aspect_ratio_parameter(),
        Parameter::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0),
    ];
    let draw = |values: &[f64]| {
        let [degrees, choice, columns] = array(values);
        Output::Pixels(render(&camera(degrees, choice, columns), 1, direction_colour))
    };
    Figure { parameters, ..Figure::new("step01_rays", draw) }
}
