//! Three figures: the picture of step 1 with a camera that the reader can set, the same picture
//! with a probe, and the checkered floor with a probe.

use crate::probe::{I, J, SIZE, draw_picture, probe_ray, probed_picture};
use crate::{
    Content, Figure, Parameter, ParameterId, ParameterValues, collect_readouts, format_number,
    format_vector,
};
use course::FOV_DEGREES;
use course::examples::checkerboard::colour as checkerboard_colour;
use step01_rays::{AspectRatio, Camera, direction_colour, render, rgb8};

pub const FIELD_OF_VIEW: ParameterId = ParameterId::new("field of view");
pub const ASPECT_RATIO: ParameterId = ParameterId::new("aspect ratio");
pub const COLUMNS: ParameterId = ParameterId::new("columns");

/// The four aspect ratios from the lecture.
const ASPECT_RATIOS: [AspectRatio; 4] = [
    AspectRatio { width: 4.0, height: 3.0 },
    AspectRatio { width: 16.0, height: 9.0 },
    AspectRatio { width: 2.35, height: 1.0 },
    AspectRatio { width: 2.59, height: 1.0 },
];

/// The names that the control shows for [`ASPECT_RATIOS`], in the same order.
const ASPECT_RATIO_NAMES: &[&str] = &["4:3", "16:9", "2.35:1", "2.59:1"];

/// The y of the floor in the example `checkerboard`.
const CHECKERBOARD_Y: f64 = -1.5;

/// The picture of step 1. Its field of view, aspect ratio and number of columns can be set.
pub fn figure() -> Figure {
    let draw = |values: &ParameterValues, columns: u32| {
        render(&camera(values, columns.min(values[COLUMNS] as u32)), 1, direction_colour)
    };
    Figure {
        parameters: vec![
            Parameter::number(FIELD_OF_VIEW, "field of view", FOV_DEGREES, [1.0, 179.0], 1.0)
                .with_symbol("θ")
                .with_unit("°"),
            aspect_ratio_parameter(),
            Parameter::number(COLUMNS, "columns", SIZE.x, [2.0, SIZE.x], 1.0).with_symbol("hRes"),
        ],
        ..Figure::new("step01_rays", Content::Picture { draw })
    }
}

/// The picture of step 1 with a probe. Step 1 has no objects yet, so the trace is short.
pub fn figure_with_probe() -> Figure {
    Figure {
        readouts: |values| {
            let ray = probe_ray(values);
            let colour = direction_colour(&ray);
            collect_readouts([
                ("i", format_number(values[I])),
                ("j", format_number(values[J])),
                ("seen", format!("V = {}", format_vector(ray.direction))),
                ("bytes", format_vector(rgb8(colour).0.map(f64::from))),
            ])
        },
        ..probed_picture("step01_pixel", [480.0, 90.0], [], |_, columns| {
            draw_picture(columns, direction_colour)
        })
    }
}

/// The checkered floor with a probe. The readouts say where the probe's ray hits the floor.
pub fn checkerboard_figure() -> Figure {
    Figure {
        readouts: |values| {
            let ray = probe_ray(values);
            let t = CHECKERBOARD_Y / ray.direction.y;
            let description = if t > 0.0 {
                format!("floor, t = {}, p = {}", format_number(t), format_vector(ray.at(t)))
            } else {
                "sky".to_owned()
            };
            collect_readouts([
                ("i", format_number(values[I])),
                ("j", format_number(values[J])),
                ("seen", description),
                ("bytes", format_vector(rgb8(checkerboard_colour(&ray)).0.map(f64::from))),
            ])
        },
        ..probed_picture("checkerboard", [320.0, 270.0], [], |_, columns| {
            draw_picture(columns, checkerboard_colour)
        })
    }
}

/// The choice of an aspect ratio, by default 16:9.
pub fn aspect_ratio_parameter() -> Parameter {
    Parameter::choice(ASPECT_RATIO, "aspect ratio", 1.0, ASPECT_RATIO_NAMES)
}

/// The camera with this many columns, and with the field of view and aspect ratio in `values`.
pub fn camera(values: &ParameterValues, columns: u32) -> Camera {
    let v_res = values.choice(ASPECT_RATIO, &ASPECT_RATIOS).v_res(columns);
    Camera::new(columns, v_res, values[FIELD_OF_VIEW].to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn probe_says_floor_where_the_picture_has_tiles() {
        let figure = checkerboard_figure();
        for (j, first_word) in [(100.0, "sky"), (179.0, "sky"), (180.0, "floor"), (359.0, "floor")]
        {
            let values = figure
                .default_values_with_probe_at([100.0, j])
                .expect("the picture has this pixel");
            let ray = probe_ray(&values);
            assert_eq!(checkerboard_colour(&ray) == direction_colour(&ray), first_word == "sky");
            assert!((figure.readouts)(&values)["seen"].starts_with(first_word), "row {j}");
        }
        let values = figure
            .default_values_with_probe_at([320.0, 270.0])
            .expect("the picture has this pixel");
        let description = &(figure.readouts)(&values)["seen"];
        assert_eq!(description, "floor, t = 9.1722, p = (0.0083, −1.5, −9.1722)");
    }
}
