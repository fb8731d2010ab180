//! A scene of the reader's own: the picture of step 5 with everything in it to set, and
//! its Rust.

mod address;
mod parameters;

pub use address::parse_address;
pub use parameters::own_scene;

use crate::figure::collect_numbers;
use crate::probe::{SIZE, place_of_point, point_at_place};
use crate::{Handle, Live, Mark, Output, Parameter};
use course::{Owner, format_scene_program};
use glam::{DVec2, DVec3};
use parameters::{PARAMETERS, Target};
use step05_phong::Camera;

/// The camera of the whole picture.
fn camera(values: &[f64]) -> Camera {
    own_scene(values).camera(SIZE.x)
}

/// The handle of a sphere or light whose first parameter, its switch, is number `first`;
/// x, y and z follow. It sets x and y, and leaves them where no point at this z is ahead.
fn object_handle(first: usize) -> Handle {
    let (_, parameter) = &PARAMETERS[first];
    Handle::new(
        parameter.group,
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
            point_at_place(&camera(values), inside, z).unwrap_or_else(|| handle.coordinates(values))
        },
    )
}

/// The picture of the scene.
pub fn picture() -> Live {
    let (targets, parameters): (Vec<Target>, Vec<Parameter>) = PARAMETERS.iter().cloned().unzip();
    let handles = targets.into_iter().enumerate().filter_map(|(first, target)| match target {
        Target::Presence(Owner::Light, _) => {
            Some(Handle { mark: Mark::Light, ..object_handle(first) })
        }
        Target::Presence(..) => Some(object_handle(first)),
        _ => None,
    });
    Live {
        handles: handles.collect(),
        parameters,
        is_allowed: |values| {
            let own = own_scene(values);
            own.position != own.target
        },
        numbers: |values| {
            let parameters = PARAMETERS.iter().map(|(_, parameter)| parameter);
            collect_numbers([
                ("rust", format_scene_program(&own_scene(values))),
                ("address", address::format_address(parameters, values)),
            ])
        },
        ..Live::new("own_scene", |values| Output::Picture(own_scene(values).picture(values[0])))
    }
}
