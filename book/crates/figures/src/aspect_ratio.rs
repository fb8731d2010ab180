use crate::Parameter;
use step01_rays::{AspectRatio, Camera};

/// The lecture's four aspect ratios.
const ASPECT_RATIOS: &[&str] = &["4:3", "16:9", "2.35:1", "2.59:1"];

/// The choice of one of them; 16:9 is the default.
pub fn aspect_ratio_parameter() -> Parameter {
    Parameter::choice("aspect ratio", 1.0, ASPECT_RATIOS)
}

/// The camera with this field of view, in degrees, and the aspect ratio of a choice.
pub fn camera(fov_degrees: f64, choice: f64, columns: f64) -> Camera {
    let h_res = columns as u32;
    let aspect_ratio: AspectRatio = ASPECT_RATIOS[choice as usize].parse().expect("it is W:H");
    Camera::new(h_res, aspect_ratio.v_res(h_res), fov_degrees.to_radians())
}
