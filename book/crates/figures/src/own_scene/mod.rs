//! The reader's own scene. It starts as the scene of step 5, and the reader can change everything
//! in it. The figure shows the scene's picture and the Rust program that draws this picture.

mod parameters;
mod program;

use crate::{COLUMNS, Content, EditableScene, Figure, Handle, Mark, ParameterId, ParameterValues};
use course::{Component, Owner};
use parameters::{PARAMETERS, Target, component_ids, own_scene, scene_including_what_is_off};
use program::format_program;
use step05_phong::nearest;

/// The figure that shows the reader's scene.
pub fn figure() -> Figure {
    let handles = PARAMETERS.iter().filter_map(|(target, presence)| match *target {
        Target::Presence(owner, k) => sphere_or_light_handle(owner, k, presence.id),
        Target::Mirrors | Target::Scalar(..) => None,
    });
    let draw = |values: &ParameterValues, columns| own_scene(values).picture(columns);
    Figure {
        parameters: PARAMETERS.iter().map(|(_, parameter)| parameter.clone()).collect(),
        handles: handles.collect(),
        editable_scene: Some(EditableScene {
            program: |values| format_program(&own_scene(values)),
            object_at: |values, position| {
                let own_scene = own_scene(values);
                let pixel = position - 0.5;
                let ray = own_scene.camera(COLUMNS).ray(pixel.x, pixel.y);
                nearest(&own_scene.scene.objects, &ray).map(|hit| hit.object.name)
            },
            colour_parameters_by_object: colour_parameters_by_object(),
        }),
        has_something_to_show: |values| {
            let own_scene = own_scene(values);
            own_scene.position != own_scene.target
        },
        ..Figure::new("own_scene", Content::Picture { draw })
    }
}

/// Returns the handle for the sphere or light with index `k`. The handle can be dragged only while
/// the switch `presence` is on. Returns None if no parameters set the position.
fn sphere_or_light_handle(owner: Owner, k: usize, presence: ParameterId) -> Option<Handle> {
    let camera_and_point = move |values: &ParameterValues| {
        values.is_on(presence).then(|| {
            let own_scene = scene_including_what_is_off(values);
            let point = match owner {
                Owner::Light => own_scene.scene.lights[k].point_light.position,
                _ => own_scene.scene.objects[k].sphere.centre,
            };
            (own_scene.camera(COLUMNS), point)
        })
    };
    let object = presence.object()?;
    let [x, y, z] = component_ids(object, Component::POSITION)?;
    Some(Handle {
        mark: if owner == Owner::Light { Mark::Light } else { Mark::Point },
        depth: Some(z),
        presence: Some(presence),
        ..Handle::of_world_xy_in_picture(object, [x, y], 0.0, camera_and_point)
    })
}

/// Every object that has a colour, with the parameters for red, green and blue.
fn colour_parameters_by_object() -> Vec<(&'static str, [ParameterId; 3])> {
    let mut objects: Vec<_> =
        PARAMETERS.iter().filter_map(|(_, parameter)| parameter.id.object()).collect();
    objects.dedup();
    let with_ids = |object| Some((object, component_ids(object, Component::COLOUR)?));
    objects.into_iter().filter_map(with_ids).collect()
}
