use super::pixel_trace::{trace_pixel, trace_shading};
use crate::probe::{draw_picture, probed_picture};
use crate::{Figure, Handle, Mark, Numbers, Parameter};
use glam::DVec3;
use std::iter::zip;
use step04_diffuse::{COOL_LIGHT, Matte, PointLight, Scene, WARM_LIGHT, colour};
use step05_phong::{Light, Material};

/// The picture of step 4: its lights to move, and a probe.
pub fn figure() -> Figure {
    let lights = [
        ("of the warm light", WARM_LIGHT.position, [[-8.0, 8.0], [-1.0, 8.0], [-12.0, 2.0]]),
        // Everywhere in these ranges, it is in the picture.
        ("of the cool light", COOL_LIGHT.position, [[-6.0, 6.0], [-3.4, 3.4], [-16.0, -11.0]]),
    ];
    let parameters = lights.iter().flat_map(|&(words, position, ranges)| {
        let coordinates = zip(["x", "y", "z"], zip(position.to_array(), ranges));
        coordinates.map(move |(symbol, (default, range))| {
            Parameter::new([symbol, words, ""], default, range, 10.0)
        })
    });
    let mut figure =
        probed_picture("step04_diffuse", [470.0, 120.0], parameters.collect(), |values| {
            let scene = moved_scene(values);
            draw_picture(values, |ray| colour(&scene, ray))
        });
    figure.handles.extend(["the warm light", "the cool light"].iter().enumerate().map(
        |(k, words)| {
            let x = 3 + 3 * k;
            let position =
                move |values: &[f64]| Some((course::camera(), DVec3::from_slice(&values[x..])));
            Handle { mark: Mark::Light, ..Handle::in_picture(words, x, 24.0, position) }
        },
    ));
    Figure { numbers, ..figure }
}

/// The scene with its lights at these values.
fn moved_scene(values: &[f64]) -> Scene<Matte, PointLight> {
    let mut scene = step04_diffuse::scene();
    for (light, position) in zip(&mut scene.lights, values[3..].chunks_exact(3)) {
        light.position = DVec3::from_slice(position);
    }
    scene
}

fn numbers(values: &[f64]) -> Numbers {
    let scene = moved_scene(values);
    let mut numbers = trace_pixel(values, &scene.objects, |ray| colour(&scene, ray));
    numbers.extend(trace_shading(values, &phong_scene(&scene)));
    numbers
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
