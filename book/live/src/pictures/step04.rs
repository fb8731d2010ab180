use super::numbers::{numbers, shading};
use super::pixel;
use crate::live::{Handle, Knob, Live, Sight};
use glam::{DVec2, DVec3};
use step04_diffuse::{COOL, Matte, PointLight, Ray, Scene, WARM, colour, render};
use step05_phong::{Light, Material};

/// The scene with its lamps where these values have them.
fn scene(values: &[f64]) -> Scene<Matte, PointLight> {
    let mut scene = step04_diffuse::scene();
    for (light, first) in scene.lights.iter_mut().zip([3, 6]) {
        light.position = DVec3::from_slice(&values[first..]);
    }
    scene
}

/// A lamp whose x, y and z are three values; it stays as deep as it is.
fn handle(words: &str, x: usize) -> Handle {
    Handle::new(
        words,
        [x, x + 1],
        |handle, values| {
            let position = DVec3::from_slice(&values[handle.knobs[0]..]);
            pixel::place(&crate::camera(), position)
        },
        |handle, values, to| {
            let inside = to.clamp(DVec2::splat(24.0), pixel::SIZE - 24.0);
            pixel::point(&crate::camera(), inside, values[handle.knobs[1] + 1])
        },
    )
}

/// The same for step 5, in which nothing shines.
fn matte(scene: &Scene<Matte, PointLight>) -> Scene<Material, Light> {
    let specular = DVec3::ZERO;
    let objects = scene.objects.iter().map(|object| {
        let matte = object.material;
        object.with_material(Material { matte, specular, shininess: 1 })
    });
    let lights = scene.lights.iter();
    Scene {
        objects: objects.collect(),
        ambient_light: scene.ambient_light,
        lights: lights
            .map(|&point_light| Light { point_light, specular })
            .collect(),
    }
}

/// The picture of step 4: its lamps to move, and a pixel to ask.
pub fn picture() -> Live {
    let mut knobs = pixel::knobs(470.0, 120.0);
    let (warm, cool) = (WARM.position, COOL.position);
    let positions = [
        (["x", "of the warm light", ""], warm.x, [-8.0, 8.0]),
        (["y", "of the warm light", ""], warm.y, [-1.0, 8.0]),
        (["z", "of the warm light", ""], warm.z, [-12.0, 2.0]),
        // Wherever these bring it, the cool light is in the picture.
        (["x", "of the cool light", ""], cool.x, [-6.0, 6.0]),
        (["y", "of the cool light", ""], cool.y, [-3.4, 3.4]),
        (["z", "of the cool light", ""], cool.z, [-16.0, -11.0]),
    ];
    knobs.extend(
        positions.map(|(words, value, range)| Knob::new(words, value, range, 10.0)),
    );
    let lamps = [handle("the warm light", 3), handle("the cool light", 6)];
    Live {
        knobs,
        handles: [pixel::cross()].into_iter().chain(lamps).collect(),
        numbers: |values| {
            let scene = scene(values);
            let shading = |ray: &Ray| shading(&matte(&scene), ray);
            let colour = |ray: &Ray| colour(&scene, ray);
            numbers(values, &scene.objects, shading, colour)
        },
        ..Live::new("step04_diffuse", |values| {
            let (camera, scene) = (pixel::camera(values), scene(values));
            Sight::Picture(render(&camera, 1, |ray| colour(&scene, ray)))
        })
    }
}
