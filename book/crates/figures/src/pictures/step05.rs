use super::pixel_trace::{trace_pixel, trace_shading};
use crate::{Interactive, Numbers, Output, Parameter, Probe, array};
use glam::DVec3;
use std::iter::zip;
use step05_phong::{Light, Material, OBJECTS, Scene, colour, nearest, render};

/// The picture of step 5: each term to switch off, a probe, and the material of the object
/// there to set.
pub struct SwitchedTerms {
    probe: Probe,
    scene: Scene<Material, Light>,
}

impl Interactive for SwitchedTerms {
    const NAME: &str = "step05_phong";
    const PROBE: Option<[f64; 2]> = Some([470.0, 120.0]);

    fn parameters() -> Vec<Parameter> {
        let terms = ["ambient", "diffuse", "specular"];
        let switches = terms.map(|term| Parameter::switch(term, true));
        let objects = step05_phong::scene().objects;
        let materials = || objects.iter().map(|object| object.material);
        let shininesses = materials().map(|material| f64::from(material.shininess));
        let reflectances = materials().map(|material| material.specular.x);
        let shininesses = object_parameters("n", shininesses, [1.0, 300.0], 1.0);
        let reflectances = object_parameters("Rₛ", reflectances, [0.0, 1.0], 20.0);
        switches.into_iter().chain(shininesses).chain(reflectances).collect()
    }

    fn from_values(values: &[f64]) -> Self {
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
        for (object, (n, r_s)) in zip(&mut scene.objects, zip(shininesses, reflectances)) {
            object.material.shininess = *n as i32;
            object.material.specular = DVec3::splat(*r_s);
        }
        Self { probe, scene }
    }

    fn draw(&self) -> Output {
        Output::Pixels(render(&self.probe.camera(), 1, |ray| colour(&self.scene, ray)))
    }

    fn numbers(&self) -> Numbers {
        let Self { probe, scene } = self;
        let mut numbers = trace_pixel(probe, &scene.objects, |ray| colour(scene, ray));
        numbers.extend(trace_shading(scene, &probe.ray()));
        numbers
    }
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
            let hit = nearest(&OBJECTS, &Probe::split_values(values).0.ray());
            hit.is_some_and(|hit| parameter.words.ends_with(hit.object.name))
        },
        ..Parameter::new([symbol, "", ""], default, range, steps_per_unit)
    })
}
