use crate::parameter::array;
use crate::{Live, Output, Parameter};
use step01_rays::{AspectRatio, Camera, direction_colour, render};

/// The aspect ratio of the course's pictures.
pub const WIDESCREEN: AspectRatio = AspectRatio { width: 16.0, height: 9.0 };

/// One of the lecture's four aspect ratios; 16:9 is the default.
pub fn aspect_ratio_parameter() -> Parameter {
    let names = &["4:3", "16:9", "2.35:1", "2.59:1"];
    Parameter::choice("aspect ratio", 1.0, names)
}

/// The aspect ratio of a value of that parameter.
pub fn aspect_ratio(choice: f64) -> AspectRatio {
    match choice as u32 {
        0 => AspectRatio { width: 4.0, height: 3.0 },
        1 => WIDESCREEN,
        2 => AspectRatio { width: 2.35, height: 1.0 },
        _ => AspectRatio { width: 2.59, height: 1.0 },
    }
}

/// The camera with this field of view, in degrees.
pub fn camera(fov_degrees: f64, aspect_ratio: AspectRatio, columns: f64) -> Camera {
    let h_res = columns as u32;
    Camera::new(h_res, aspect_ratio.v_res(h_res), fov_degrees.to_radians())
}

/// The picture of step 1, with its camera to set.
pub fn picture() -> Live {
    Live {
        parameters: vec![
            Parameter::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
            aspect_ratio_parameter(),
            Parameter::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0),
        ],
        ..Live::new("step01_rays", |values| {
            let [degrees, choice, columns] = array(values);
            let camera = camera(degrees, aspect_ratio(choice), columns);
            Output::Picture(render(&camera, 1, direction_colour))
        })
    }
}
