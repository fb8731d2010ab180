//! The picture of step 5, in which the reader can switch terms off and set materials.

use super::pixel_trace::{trace_phong_terms, trace_pixel};
use crate::probe::{draw_picture, probe_ray, probed_picture};
use crate::{Figure, Parameter, ParameterId, ParameterValues, Readouts};
use glam::DVec3;
use step05_phong::{Light, Material, OBJECTS, Object, Scene, colour, nearest};

const AMBIENT: ParameterId = ParameterId::new("ambient");
const DIFFUSE: ParameterId = ParameterId::new("diffuse");
const SPECULAR: ParameterId = ParameterId::new("specular");

fn shininess_id(object: &'static str) -> ParameterId {
    ParameterId::of(object, "shininess")
}

fn specular_reflectance_id(object: &'static str) -> ParameterId {
    ParameterId::of(object, "specular reflectance")
}

/// The picture of step 5, with a probe. Each term can be switched off, and the material of the
/// object at the probe can be set.
pub fn figure() -> Figure {
    let switches = [(AMBIENT, "ambient"), (DIFFUSE, "diffuse"), (SPECULAR, "specular")]
        .map(|(id, term)| Parameter::switch(id, term, true));
    let objects = step05_phong::scene().objects;
    let shininesses = objects.iter().map(|Object { name, material, .. }| {
        let default = f64::from(material.shininess);
        parameter_shown_if_probed(shininess_id(name), name, default, [1.0, 300.0], 1.0)
            .with_symbol("n")
    });
    let reflectances = objects.iter().map(|Object { name, material, .. }| {
        let default = material.specular.x;
        parameter_shown_if_probed(specular_reflectance_id(name), name, default, [0.0, 1.0], 20.0)
            .with_symbol("Rₛ")
    });
    let parameters = switches.into_iter().chain(shininesses).chain(reflectances);
    Figure {
        readouts,
        row_count: OBJECTS.len(),
        ..probed_picture("step05_phong", [470.0, 120.0], parameters, |values, columns| {
            let scene = changed_scene(values);
            draw_picture(columns, |ray| colour(&scene, ray))
        })
    }
}

/// The scene of step 5 with the reader's materials, and without the terms that the reader has
/// switched off.
fn changed_scene(values: &ParameterValues) -> Scene<Material, Light> {
    let mut scene = step05_phong::scene();
    scene.ambient_light *= values[AMBIENT];
    for light in &mut scene.lights {
        light.point_light.diffuse *= values[DIFFUSE];
        light.specular *= values[SPECULAR];
    }
    for object in &mut scene.objects {
        object.material.shininess = values[shininess_id(object.name)] as i32;
        object.material.specular = DVec3::splat(values[specular_reflectance_id(object.name)]);
    }
    scene
}

fn readouts(values: &ParameterValues) -> Readouts {
    let scene = changed_scene(values);
    let mut readouts = trace_pixel(values, &scene.objects, |ray| colour(&scene, ray));
    readouts.extend(trace_phong_terms(values, &scene));
    readouts
}

/// A parameter that belongs to an object. The page shows the parameter's control only while the
/// probe is on the object.
pub fn parameter_shown_if_probed(
    id: ParameterId,
    object: &str,
    default: f64,
    range: [f64; 2],
    steps_per_unit: f64,
) -> Parameter {
    let parameter =
        Parameter::number(id, format!("of the {object}"), default, range, steps_per_unit);
    let has_control = |parameter: &Parameter, values: &ParameterValues| {
        let hit = nearest(&OBJECTS, &probe_ray(values));
        hit.is_some_and(|hit| parameter.id.object() == Some(hit.object.name))
    };
    Parameter { has_control, ..parameter }
}
