//! The picture of step 4, with lights that the reader can move.

use super::pixel_trace::{trace_phong_terms, trace_pixel};
use crate::probe::{draw_picture, probed_picture};
use crate::{Axis, Figure, Handle, Mark, Parameter, ParameterValues, PointId, Readouts};
use course::LIGHT_NAMES;
use glam::DVec3;
use step04_diffuse::{COOL_LIGHT, Matte, OBJECTS, PointLight, Scene, WARM_LIGHT, colour};
use step05_phong::{Light, Material};

/// The ids of the lights' positions, in the order of the lights in the scene.
const LIGHTS: [PointId; 2] =
    [PointId(LIGHT_NAMES[0].with_article), PointId(LIGHT_NAMES[1].with_article)];

/// The picture of step 4, with a probe. The lights can be moved.
pub fn figure() -> Figure {
    let [warm, cool] = LIGHTS;
    let parameters = [
        position_parameters(warm, WARM_LIGHT.position, [[-8.0, 8.0], [-1.0, 8.0], [-12.0, 2.0]]),
        // Everywhere in these ranges, the light is inside the picture.
        position_parameters(cool, COOL_LIGHT.position, [[-6.0, 6.0], [-3.4, 3.4], [-16.0, -11.0]]),
    ];
    let mut figure =
        probed_picture("step04_diffuse", [470.0, 120.0], parameters.concat(), |values, columns| {
            let scene = scene_with_moved_lights(values);
            draw_picture(columns, |ray| colour(&scene, ray))
        });
    figure.handles.extend(LIGHTS.map(|light| {
        let position =
            move |values: &ParameterValues| Some((course::camera(), values.point_in_space(light)));
        let handle =
            Handle::of_world_xy_in_picture(light.0, [light.x(), light.y()], 24.0, position);
        Handle { mark: Mark::Light, ..handle }
    }));
    Figure { readouts, row_count: OBJECTS.len(), ..figure }
}

/// The parameters for a light's coordinates.
fn position_parameters(light: PointId, position: DVec3, ranges: [[f64; 2]; 3]) -> [Parameter; 3] {
    let label = format!("of {}", light.0);
    let [x, y, z] = ranges;
    [
        Parameter::number(light.x(), &*label, position.x, x, 10.0)
            .with_symbol("x")
            .with_axis(Axis::Right),
        Parameter::number(light.y(), &*label, position.y, y, 10.0)
            .with_symbol("y")
            .with_axis(Axis::Up),
        Parameter::number(light.z(), &*label, position.z, z, 10.0).with_symbol("z"),
    ]
}

/// The scene with its lights at the positions in `values`.
fn scene_with_moved_lights(values: &ParameterValues) -> Scene<Matte, PointLight> {
    let mut scene = step04_diffuse::scene();
    for (light, position) in scene.lights.iter_mut().zip(LIGHTS) {
        light.position = values.point_in_space(position);
    }
    scene
}

fn readouts(values: &ParameterValues) -> Readouts {
    let scene = scene_with_moved_lights(values);
    let mut readouts = trace_pixel(values, &scene.objects, |ray| colour(&scene, ray));
    readouts.extend(trace_phong_terms(values, &phong_scene(&scene)));
    readouts
}

/// Converts a scene of step 4 to a scene of step 5 without highlights.
fn phong_scene(scene: &Scene<Matte, PointLight>) -> Scene<Material, Light> {
    let specular = DVec3::ZERO;
    let objects = scene.objects.iter().map(|object| {
        let matte = object.material;
        object.with_material(Material { matte, specular, shininess: 1 })
    });
    let lights = scene.lights.iter();
    Scene {
        objects: objects.collect(),
        ambient_light: scene.ambient_light,
        lights: lights.map(|&point_light| Light { point_light, specular }).collect(),
    }
}
