use super::pixel_trace::{trace_pixel, trace_shading};
use crate::probe::{draw_picture, probe_ray, probed_picture};
use crate::{Figure, Numbers, Parameter, array};
use glam::DVec3;
use std::iter::zip;
use step05_phong::{Light, Material, OBJECTS, Scene, colour, nearest};

/// The picture of step 5: each term to switch off, a probe, and the material of the object
/// there to set.
pub fn figure() -> Figure {
    let switches = ["ambient", "diffuse", "specular"].map(|term| Parameter::switch(term, true));
    let objects = step05_phong::scene().objects;
    let materials = || objects.iter().map(|object| object.material);
    let shininesses = materials().map(|material| f64::from(material.shininess));
    let reflectances = materials().map(|material| material.specular.x);
    let shininesses = object_parameters("n", shininesses, [1.0, 300.0], 1.0);
    let reflectances = object_parameters("Rₛ", reflectances, [0.0, 1.0], 20.0);
    let parameters = switches.into_iter().chain(shininesses).chain(reflectances).collect();
    Figure {
        numbers,
        ..probed_picture("step05_phong", [470.0, 120.0], parameters, |values| {
            let scene = changed_scene(values);
            draw_picture(values, |ray| colour(&scene, ray))
        })
    }
}

/// The scene with the terms and materials of these values.
fn changed_scene(values: &[f64]) -> Scene<Material, Light> {
    let (terms, materials) = values[3..].split_at(3);
    let [ambient, diffuse, specular] = array(terms);
    let (shininesses, reflectances) = materials.split_at(OBJECTS.len());
    let mut scene = step05_phong::scene();
    scene.ambient_light *= ambient;
    for light in &mut scene.lights {
        light.point_light.diffuse *= diffuse;
        light.specular *= specular;
    }
    for (object, (n, r_s)) in zip(&mut scene.objects, zip(shininesses, reflectances)) {
        object.material.shininess = *n as i32;
        object.material.specular = DVec3::splat(*r_s);
    }
    scene
}

fn numbers(values: &[f64]) -> Numbers {
    let scene = changed_scene(values);
    let mut numbers = trace_pixel(values, &scene.objects, |ray| colour(&scene, ray));
    numbers.extend(trace_shading(values, &scene));
    numbers
}

/// A parameter of each object, with these defaults; the page has a control for that of the
/// object at the probe.
pub fn object_parameters(
    symbol: &'static str,
    defaults: impl Iterator<Item = f64>,
    range: [f64; 2],
    steps_per_unit: f64,
) -> impl Iterator<Item = Parameter> {
    zip(OBJECTS, defaults).map(move |(object, default)| Parameter {
        words: format!("of the {}", object.name),
        has_control: |parameter, values| {
            let hit = nearest(&OBJECTS, &probe_ray(values));
            hit.is_some_and(|hit| parameter.words.ends_with(hit.object.name))
        },
        ..Parameter::new([symbol, "", ""], default, range, steps_per_unit)
    })
}
