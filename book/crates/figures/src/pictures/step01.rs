use crate::{Figure, Output, Parameter, array};
use step01_rays::{AspectRatio, Camera, direction_colour, render};

/// The lecture's four aspect ratios, as the control shows them.
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
    let v_res = aspect_ratio(ASPECT_RATIOS[choice as usize]).v_res(h_res);
    Camera::new(h_res, v_res, fov_degrees.to_radians())
}

/// The aspect ratio that is written W:H.
fn aspect_ratio(text: &str) -> AspectRatio {
    let numbers: Vec<f64> = text.split(':').filter_map(|number| number.parse().ok()).collect();
    let [width, height] = array(&numbers);
    AspectRatio { width, height }
}
