use super::picture;
use crate::live::{Knob, Live, number};
use step01_rays::{AspectRatio, Camera, Ray, direction_colour};

/// The picture of step 1, with the field of view, the shape and the columns to set, and
/// with unit vectors if asked for.
pub const STEP01: Live = Live {
    name: "step01_rays",
    knobs: &[
        Knob::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
        ASPECT_RATIO,
        Knob::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0),
        Knob::choice("normalised", 0.0, &["off", "on"]),
    ],
    handles: &[],
    is_allowed: |values| camera(&values[..3]).is_ok(),
    sight: |values| {
        let is_unit = values[3] == 1.0;
        picture(&seen(&values[..3]), |ray| match is_unit {
            true => direction_colour(&Ray {
                direction: ray.direction.normalize(),
                ..*ray
            }),
            false => direction_colour(ray),
        })
    },
    numbers: |values| {
        let camera = seen(&values[..3]);
        vec![
            ("rows".into(), camera.v_res.to_string()),
            ("step".into(), number(camera.matrix.x_axis.x)),
        ]
    },
    beside: None,
};

/// The lecture's four; 16:9 is printed.
pub const ASPECT_RATIO: Knob =
    Knob::choice("aspect ratio", 1.0, &["4:3", "16:9", "2.35:1", "2.59:1"]);

const SHAPES: [[f64; 2]; 4] = [[4.0, 3.0], [16.0, 9.0], [2.35, 1.0], [2.59, 1.0]];

/// The camera of these values.
pub fn camera(values: &[f64]) -> Result<Camera, String> {
    let &[degrees, shape, columns] = values else { return Err(String::new()) };
    let [width, height] = SHAPES[shape as usize];
    let rows = AspectRatio { width, height }.v_res(columns as u32);
    Ok(Camera::new(columns as u32, rows, degrees.to_radians()))
}

/// The camera of allowed values.
pub fn seen(values: &[f64]) -> Camera {
    camera(values).unwrap_or_else(|_| crate::camera())
}
