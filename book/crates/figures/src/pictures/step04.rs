use super::pixel_trace::{trace_pixel, trace_shading};
use crate::probe::Probe;
use crate::{Handle, Interactive, Mark, Numbers, Output, Parameter};
use glam::DVec3;
use step04_diffuse::{COOL, Matte, PointLight, Ray, Scene, WARM, colour, render};
use step05_phong::{Light, Material};

/// The picture of step 4: its lights to move, and a probe.
pub struct MovedLights {
    probe: Probe,
    scene: Scene<Matte, PointLight>,
}

impl Interactive for MovedLights {
    const NAME: &str = "step04_diffuse";

    fn parameters() -> Vec<Parameter> {
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
        parameters.extend(
            coordinates.map(|(words, value, range)| Parameter::new(words, value, range, 10.0)),
        );
        parameters
    }

    fn from_values(values: &[f64]) -> Self {
        let (probe, others) = Probe::split_values(values);
        let mut scene = step04_diffuse::scene();
        for (light, position) in scene.lights.iter_mut().zip(others.chunks_exact(3)) {
            light.position = DVec3::from_slice(position);
        }
        Self { probe, scene }
    }

    fn handles() -> Vec<Handle> {
        let handle = |words, k: usize| {
            let position =
                move |picture: &Self| Some((course::camera(), picture.scene.lights[k].position));
            Self::handle_in_picture(words, 3 + 3 * k, 24.0, position).with_mark(Mark::Light)
        };
        vec![Probe::handle(), handle("the warm light", 0), handle("the cool light", 1)]
    }

    fn draw(&self) -> Output {
        render(&self.probe.camera(), 1, |ray| colour(&self.scene, ray)).into()
    }

    fn numbers(&self) -> Numbers {
        let trace_shading = |ray: &Ray| trace_shading(&phong_scene(&self.scene), ray);
        let colour = |ray: &Ray| colour(&self.scene, ray);
        trace_pixel(&self.probe, &self.scene.objects, trace_shading, colour)
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
