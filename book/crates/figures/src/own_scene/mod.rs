//! A scene of the reader's own: the picture of step 5 with everything in it to set, and
//! its Rust.

mod address;
mod parameters;
mod scene;

pub use address::parse_address;
pub use scene::own_scene;

use crate::live::collect_numbers;
use crate::pictures::render_scene;
use crate::probe::{SIZE, place_of_point, point_at_place};
use crate::{Handle, Live, Mark, Output};
use course::examples::mirror;
use course::{Settings, format_scene_program};
use glam::{DVec2, DVec3};
use parameters::{LIGHT, PARAMETERS, SETTINGS, SPHERE, SPHERES, settings};
use scene::mirror_scene;
use step05_phong::{Camera, render};

/// The camera of the whole picture.
fn camera(values: &[f64]) -> Camera {
    settings(values).camera(SIZE.x)
}

/// The picture of these values: by step 5, or by the example `mirror`, in which a ray may
/// meet ten mirrors.
fn draw(values: &[f64]) -> Output {
    let settings = settings(values);
    let camera = settings.camera(settings.columns);
    if !settings.has_mirrors {
        return render_scene(&camera, &own_scene(values));
    }
    let scene = mirror_scene(values);
    Output::Picture(render(&camera, 1, |ray| mirror::colour(&scene, ray, 10, mirror::OFFSET)))
}

/// The handle of a sphere or light whose first parameter, its switch, is number `first`;
/// x, y and z follow. It sets x and y, and leaves them where no point at this z is ahead.
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
            point_at_place(&camera(values), inside, z).unwrap_or_else(|| handle.coordinates(values))
        },
    )
}

/// The picture of the scene.
pub fn picture() -> Live {
    let first_light = SETTINGS + SPHERES * SPHERE;
    let spheres = (SETTINGS..first_light).step_by(SPHERE).map(object_handle);
    let lights = (first_light..PARAMETERS.len()).step_by(LIGHT);
    let lights = lights.map(|first| Handle { mark: Mark::Light, ..object_handle(first) });
    Live {
        parameters: PARAMETERS.clone(),
        handles: spheres.chain(lights).collect(),
        is_allowed: |values| {
            let Settings { position, target, .. } = settings(values);
            position != target
        },
        numbers: |values| {
            collect_numbers([
                ("rust", format_scene_program(&settings(values), &mirror_scene(values))),
                ("address", address::format_address(&PARAMETERS, values)),
            ])
        },
        ..Live::new("own_scene", draw)
    }
}
