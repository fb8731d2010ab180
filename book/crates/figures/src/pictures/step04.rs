use super::pixel_trace::{trace_pixel, trace_shading};
use crate::probe::{self, Probe};
use crate::{Handle, Live, Mark, Output, Parameter};
use glam::{DVec2, DVec3};
use step04_diffuse::{COOL, Matte, PointLight, Ray, Scene, WARM, colour, render};
use step05_phong::{Light, Material};

/// The probe, and the scene with both lights where these values have them.
fn probe_and_scene(values: &[f64]) -> (Probe, Scene<Matte, PointLight>) {
    let (probe, others) = Probe::split_values(values);
    let positions = others.chunks_exact(3).map(DVec3::from_slice);
    let mut scene = step04_diffuse::scene();
    for (light, position) in scene.lights.iter_mut().zip(positions) {
        light.position = position;
    }
    (probe, scene)
}

/// The handle of a light whose x, y and z are three parameters; z stays.
fn light_handle(words: &str, x: usize) -> Handle {
    let handle = Handle::new(
        words,
        [x, x + 1],
        |handle, values| {
            let position = DVec3::from_slice(&values[handle.parameters[0]..]);
            probe::place_of_point(&crate::camera(), position)
        },
        |handle, values, place| {
            let inside = place.clamp(DVec2::splat(24.0), probe::SIZE - 24.0);
            let z = values[handle.parameters[1] + 1];
            probe::point_at_place(&crate::camera(), inside, z)
                .unwrap_or_else(|| handle.coordinates(values))
        },
    );
    Handle { mark: Mark::Light, ..handle }
}

/// The scene as one of step 5, without highlights.
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

/// The picture of step 4: its lights to move, and a probe.
pub fn picture() -> Live {
    let mut parameters = Probe::parameters(470.0, 120.0);
    let (warm, cool) = (WARM.position, COOL.position);
    let coordinates = [
        (["x", "of the warm light", ""], warm.x, [-8.0, 8.0]),
        (["y", "of the warm light", ""], warm.y, [-1.0, 8.0]),
        (["z", "of the warm light", ""], warm.z, [-12.0, 2.0]),
        // Everywhere in these ranges, the cool light is in the picture.
        (["x", "of the cool light", ""], cool.x, [-6.0, 6.0]),
        (["y", "of the cool light", ""], cool.y, [-3.4, 3.4]),
        (["z", "of the cool light", ""], cool.z, [-16.0, -11.0]),
    ];
    parameters
        .extend(coordinates.map(|(words, value, range)| Parameter::new(words, value, range, 10.0)));
    Live {
        parameters,
        handles: vec![
            Probe::handle(),
            light_handle("the warm light", 3),
            light_handle("the cool light", 6),
        ],
        numbers: |values| {
            let (probe, scene) = probe_and_scene(values);
            let trace_shading = |ray: &Ray| trace_shading(&phong_scene(&scene), ray);
            let colour = |ray: &Ray| colour(&scene, ray);
            trace_pixel(&probe, &scene.objects, trace_shading, colour)
        },
        ..Live::new("step04_diffuse", |values| {
            let (probe, scene) = probe_and_scene(values);
            let colour = |ray: &Ray| colour(&scene, ray);
            Output::Picture(render(&probe.camera(), 1, colour))
        })
    }
}
