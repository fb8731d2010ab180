use crate::live::{Knob, Live, Sight};
use step01_rays::{AspectRatio, Camera, Ray, direction_colour, render};

/// The lecture's four; 16:9 is printed.
pub fn aspect_ratio() -> Knob {
    Knob::choice("aspect ratio", 1.0, &["4:3", "16:9", "2.35:1", "2.59:1"])
}

const SHAPES: [[f64; 2]; 4] = [[4.0, 3.0], [16.0, 9.0], [2.35, 1.0], [2.59, 1.0]];

/// The camera whose first values are its field of view, its shape and its columns.
pub fn camera(values: &[f64]) -> Camera {
    let [width, height] = SHAPES[values[1] as usize];
    let columns = values[2] as u32;
    let rows = AspectRatio { width, height }.v_res(columns);
    Camera::new(columns, rows, values[0].to_radians())
}

/// The picture of step 1, with the field of view, the shape and the columns to set, and
/// with unit vectors if asked for.
pub fn picture() -> Live {
    Live {
        knobs: vec![
            Knob::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
            aspect_ratio(),
            Knob::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0),
            Knob::switch("normalised", false),
        ],
        ..Live::new("step01_rays", |values| {
            let is_unit = values[3] == 1.0;
            let colour = |ray: &Ray| {
                let v = ray.direction;
                let direction = if is_unit { v.normalize() } else { v };
                direction_colour(&Ray { direction, ..*ray })
            };
            Sight::Picture(render(&camera(values), 1, colour))
        })
    }
}
