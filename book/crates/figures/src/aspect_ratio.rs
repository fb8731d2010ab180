use crate::Parameter;
use step01_rays::{AspectRatio, Camera};

/// One of the lecture's four aspect ratios; 16:9 is the default.
pub fn aspect_ratio_parameter() -> Parameter {
    let names = &["4:3", "16:9", "2.35:1", "2.59:1"];
    Parameter::choice("aspect ratio", 1.0, names)
}

/// The aspect ratio of a value of that parameter.
pub fn aspect_ratio(choice: f64) -> AspectRatio {
    let (width, height) = match choice as u32 {
        0 => (4.0, 3.0),
        1 => (16.0, 9.0),
        2 => (2.35, 1.0),
        _ => (2.59, 1.0),
    };
    AspectRatio { width, height }
}

/// The camera with this field of view, in degrees.
pub fn camera(fov_degrees: f64, aspect_ratio: AspectRatio, columns: f64) -> Camera {
    let h_res = columns as u32;
    Camera::new(h_res, aspect_ratio.v_res(h_res), fov_degrees.to_radians())
}
