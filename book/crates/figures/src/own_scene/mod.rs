//! A scene of the reader's own: the picture of step 5 with everything in it to set, and
//! its Rust.

mod address;
mod parameters;

pub use address::parse_address;

use crate::projection::SIZE;
use crate::{Figure, Handle, Mark, Output, collect_numbers};
use course::{Owner, format_scene_program};
use glam::DVec3;
use parameters::{PARAMETERS, Target, own_scene};
use step05_phong::nearest;

/// The picture of the scene.
pub fn figure() -> Figure {
    // The switch of a sphere or light comes before its position.
    let handles = PARAMETERS.iter().enumerate().filter_map(|(k, (target, parameter))| {
        let Target::Presence(owner, _) = *target else { return None };
        let mark = if owner == Owner::Light { Mark::Light } else { Mark::Point };
        let camera_and_point = move |values: &[f64]| {
            let point = DVec3::from_slice(&values[k + 1..]);
            (values[k] == 1.0).then(|| (own_scene(values).camera(SIZE.x), point))
        };
        Some(Handle { mark, ..Handle::in_picture(parameter.group, k + 1, 0.0, camera_and_point) })
    });
    // The first parameter is the columns.
    let draw = |values: &[f64]| Output::Pixels(own_scene(values).picture(values[0]));
    Figure {
        parameters: PARAMETERS.iter().map(|(_, parameter)| parameter.clone()).collect(),
        handles: handles.collect(),
        numbers: |values| {
            collect_numbers([
                ("rust", format_scene_program(&own_scene(values))),
                ("address", address::format_address(values)),
            ])
        },
        group_at: |values, place| {
            let own = own_scene(values);
            let pixel = place - 0.5;
            let ray = own.camera(SIZE.x).ray(pixel.x, pixel.y);
            nearest(&own.scene.objects, &ray).map(|hit| hit.object.name)
        },
        is_allowed: |values| {
            let own = own_scene(values);
            own.position != own.target
        },
        ..Figure::new("own_scene", draw)
    }
}
