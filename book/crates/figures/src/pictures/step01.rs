use crate::{Figure, Output, Parameter, array};
use step01_rays::{AspectRatio, Camera, direction_colour, render};

/// The lecture's four aspect ratios.
const ASPECT_RATIOS: &[&str] = &["4:3", "16:9", "2.35:1", "2.59:1"];

/// The picture of step 1, with its camera to set.
pub fn figure() -> Figure {
    let parameters = vec![
        Parameter::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
        aspect_ratio_parameter(),
        Parameter::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0),
    ];
    let draw = |values: &[f64]| Output::Pixels(render(&camera(values), 1, direction_colour));
    Figure { parameters, ..Figure::new("step01_rays", draw) }
}

/// The choice of an aspect ratio; 16:9 is the default.
pub fn aspect_ratio_parameter() -> Parameter {
    Parameter::choice("aspect ratio", 1.0, ASPECT_RATIOS)
}

/// The camera with a field of view, in degrees, an aspect ratio, and so many columns.
pub fn camera(values: &[f64]) -> Camera {
    let [fov_degrees, choice, columns] = array(values);
    let h_res = columns as u32;
    let aspect_ratio: AspectRatio = ASPECT_RATIOS[choice as usize].parse().expect("it is W:H");
    Camera::new(h_res, aspect_ratio.v_res(h_res), fov_degrees.to_radians())
}
