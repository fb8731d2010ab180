use crate::Parameter;
use step01_rays::{AspectRatio, Camera};

/// The lecture's four aspect ratios.
const ASPECT_RATIOS: [AspectRatio; 4] = [
    AspectRatio { width: 4.0, height: 3.0 },
    AspectRatio { width: 16.0, height: 9.0 },
    AspectRatio { width: 2.35, height: 1.0 },
    AspectRatio { width: 2.59, height: 1.0 },
];

/// The choice of one of them; 16:9 is the default.
pub fn aspect_ratio_parameter() -> Parameter {
    Parameter::choice("aspect ratio", 1.0, &["4:3", "16:9", "2.35:1", "2.59:1"])
}

/// The camera with this field of view, in degrees, and the aspect ratio of a choice.
pub fn camera(fov_degrees: f64, choice: f64, columns: f64) -> Camera {
    let h_res = columns as u32;
    let v_res = ASPECT_RATIOS[choice as usize].v_res(h_res);
    Camera::new(h_res, v_res, fov_degrees.to_radians())
}
