use super::pixel_trace::{trace_pixel, trace_shading};
use crate::{Handle, Interactive, Mark, Numbers, Output, Parameter, Probe};
use glam::DVec3;
use std::iter::zip;
use step04_diffuse::{COOL, Matte, PointLight, Scene, WARM, colour, render};
use step05_phong::{Light, Material};

/// The picture of step 4: its lights to move, and a probe.
pub struct MovedLights {
    probe: Probe,
    scene: Scene<Matte, PointLight>,
}

impl Interactive for MovedLights {
    const NAME: &str = "step04_diffuse";
    const PROBE: Option<[f64; 2]> = Some([470.0, 120.0]);

    fn parameters() -> Vec<Parameter> {
        let mut parameters = vec![];
        for (words, position, ranges) in [
            ("of the warm light", WARM.position, [[-8.0, 8.0], [-1.0, 8.0], [-12.0, 2.0]]),
            // Everywhere in these ranges, it is in the picture.
            ("of the cool light", COOL.position, [[-6.0, 6.0], [-3.4, 3.4], [-16.0, -11.0]]),
        ] {
            for (symbol, (default, range)) in zip(["x", "y", "z"], zip(position.to_array(), ranges))
            {
                parameters.push(Parameter::new([symbol, words, ""], default, range, 10.0));
            }
        }
        parameters
    }

    fn from_values(values: &[f64]) -> Self {
        let (probe, others) = Probe::split_values(values);
        let mut scene = step04_diffuse::scene();
        for (light, position) in zip(&mut scene.lights, others.chunks_exact(3)) {
            light.position = DVec3::from_slice(position);
        }
        Self { probe, scene }
    }

    fn handles() -> Vec<Handle> {
        let handle = |words, k: usize| {
            let position =
                move |picture: &Self| Some((course::camera(), picture.scene.lights[k].position));
            let handle = Self::handle_in_picture(words, 3 + 3 * k, 24.0, position);
            Handle { mark: Mark::Light, ..handle }
        };
        vec![handle("the warm light", 0), handle("the cool light", 1)]
    }

    fn draw(&self) -> Output {
        Output::Pixels(render(&self.probe.camera(), 1, |ray| colour(&self.scene, ray)))
    }

    fn numbers(&self) -> Numbers {
        let Self { probe, scene } = self;
        let mut numbers = trace_pixel(probe, &scene.objects, |ray| colour(scene, ray));
        numbers.extend(trace_shading(&phong_scene(scene), &probe.ray()));
        numbers
    }
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
