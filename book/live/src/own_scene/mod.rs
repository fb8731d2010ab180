//! A scene of the reader's own: the picture of step 5 with everything in it to set, and
//! its Rust.

mod address;
mod parameters;
mod rust;
mod scene;

pub use address::parse_address;
pub use scene::own_scene;

use crate::live::collect_numbers;
use crate::parameter::array;
use crate::pictures::pixel_probe::{SIZE, place_of_point, point_at_place};
use crate::pictures::render_scene;
use crate::pictures::step01::{self, WIDESCREEN};
use crate::{Handle, Live, Mark};
use glam::{DVec2, DVec3};
use parameters::{LIGHT, PARAMETERS, SETTINGS, SPHERE, SPHERES, split_parameters};
use step05_phong::Camera;

/// The columns of the picture, and its field of view in degrees.
fn columns_and_degrees(values: &[f64]) -> (f64, f64) {
    let (settings, _, _) = split_parameters(values);
    let [columns, degrees, _red, _green, _blue] = array(settings);
    (columns, degrees)
}

/// The camera of the whole picture.
fn camera(values: &[f64]) -> Camera {
    let (_, degrees) = columns_and_degrees(values);
    step01::camera(degrees, WIDESCREEN, SIZE.x)
}

/// The handle of a sphere or light whose first parameter, its switch, is number `first`;
/// x, y and z follow. It sets x and y.
fn object_handle(first: usize) -> Handle {
    Handle::new(
        PARAMETERS[first].group,
        [first + 1, first + 2],
        |handle, values| {
            let x = handle.parameters[0];
            let is_there = values[x - 1] == 1.0;
            let position = DVec3::from_slice(&values[x..]);
            let place = place_of_point(&camera(values), position);
            place.filter(|_| is_there)
        },
        |handle, values, place| {
            let z = values[handle.parameters[1] + 1];
            let inside = place.clamp(DVec2::ZERO, SIZE);
            point_at_place(&camera(values), inside, z)
        },
    )
}

/// The picture of the scene.
pub fn picture() -> Live {
    let first_light = SETTINGS + SPHERES * SPHERE;
    let spheres = (SETTINGS..first_light).step_by(SPHERE).map(object_handle);
    let lights = (first_light..PARAMETERS.len()).step_by(LIGHT);
    let lights =
        lights.map(|first| Handle { mark: Mark::Light, ..object_handle(first) });
    Live {
        parameters: PARAMETERS.clone(),
        handles: spheres.chain(lights).collect(),
        numbers: |values| {
            let (_, degrees) = columns_and_degrees(values);
            collect_numbers([
                ("rust", rust::program(&own_scene(values), degrees)),
                ("address", address::format_address(&PARAMETERS, values)),
            ])
        },
        ..Live::new("own_scene", |values| {
            let (columns, degrees) = columns_and_degrees(values);
            let camera = step01::camera(degrees, WIDESCREEN, columns);
            render_scene(&camera, &own_scene(values))
        })
    }
}
