use super::pixel_trace::{trace_pixel, trace_shading};
use super::render_scene;
use crate::parameter::array;
use crate::probe::Probe;
use crate::{Live, Parameter};
use glam::DVec3;
use step05_phong::{Light, Material, OBJECTS, Ray, Scene, colour, nearest};

/// The probe, and the scene in which each term has its factor, 0 or 1, and each object
/// its n and R_s.
fn probe_and_scene(values: &[f64]) -> (Probe, Scene<Material, Light>) {
    let (probe, others) = Probe::split_values(values);
    let (terms, materials) = others.split_at(3);
    let [ambient, diffuse, specular] = array(terms);
    let (shininesses, reflectances) = materials.split_at(OBJECTS.len());
    let mut scene = step05_phong::scene();
    scene.ambient_light *= ambient;
    for light in &mut scene.lights {
        light.point_light.diffuse *= diffuse;
        light.specular *= specular;
    }
    let materials = shininesses.iter().zip(reflectances);
    for (object, (n, r_s)) in scene.objects.iter_mut().zip(materials) {
        object.material.shininess = *n as i32;
        object.material.specular = DVec3::splat(*r_s);
    }
    (probe, scene)
}

/// A parameter of each object, with these defaults; the page has a control for that of the
/// object at the probe.
pub fn object_parameters(
    symbol: &'static str,
    defaults: impl Iterator<Item = f64>,
    range: [f64; 2],
    steps_per_unit: f64,
) -> impl Iterator<Item = Parameter> {
    OBJECTS.iter().zip(defaults).map(move |(object, default)| Parameter {
        words: format!("of the {}", object.name),
        has_control: |parameter, values| {
            let (probe, _) = Probe::split_values(values);
            let hit = nearest(&OBJECTS, &probe.ray());
            hit.is_some_and(|hit| parameter.words.ends_with(hit.object.name))
        },
        ..Parameter::new([symbol, "", ""], default, range, steps_per_unit)
    })
}

/// The picture of step 5: each term to switch off, a probe, and the material of the object
/// there to set.
pub fn picture() -> Live {
    let mut parameters = Probe::parameters(470.0, 120.0);
    let terms = ["ambient", "diffuse", "specular"];
    parameters.extend(terms.map(|term| Parameter::switch(term, true)));
    let objects = step05_phong::scene().objects;
    let materials = || objects.iter().map(|object| object.material);
    let shininesses = materials().map(|material| f64::from(material.shininess));
    let reflectances = materials().map(|material| material.specular.x);
    parameters.extend(object_parameters("n", shininesses, [1.0, 300.0], 1.0));
    parameters.extend(object_parameters("Rₛ", reflectances, [0.0, 1.0], 20.0));
    Live {
        parameters,
        handles: vec![Probe::handle()],
        numbers: |values| {
            let (probe, scene) = probe_and_scene(values);
            let trace_shading = |ray: &Ray| trace_shading(&scene, ray);
            let colour = |ray: &Ray| colour(&scene, ray);
            trace_pixel(&probe, &scene.objects, trace_shading, colour)
        },
        ..Live::new("step05_phong", |values| {
            let (probe, scene) = probe_and_scene(values);
            render_scene(&probe.camera(), &scene)
        })
    }
}
