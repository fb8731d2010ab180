use super::numbers::{numbers, shading};
use super::{pixel, shaded};
use crate::live::{Knob, Live};
use glam::DVec3;
use step05_phong::{Light, Material, OBJECTS, Ray, Scene, colour, nearest};

/// The scene in the light of the terms that are switched on, that of the others being 0;
/// each object has the n and the R_s of these values.
fn scene(values: &[f64]) -> Scene<Material, Light> {
    let mut scene = step05_phong::scene();
    scene.ambient_light *= values[3];
    for light in &mut scene.lights {
        light.point_light.diffuse *= values[4];
        light.specular *= values[5];
    }
    let materials = values[6..15].iter().zip(&values[15..]);
    for (object, (n, r_s)) in scene.objects.iter_mut().zip(materials) {
        object.material.shininess = *n as i32;
        object.material.specular = DVec3::splat(*r_s);
    }
    scene
}

/// A knob for the material of each object; the one of the object that is asked is shown.
fn knobs(
    symbol: &'static str,
    value: fn(&Material) -> f64,
    range: [f64; 2],
    steps: f64,
) -> impl Iterator<Item = Knob> {
    let objects = step05_phong::scene().objects.into_iter();
    objects.map(move |object| Knob {
        words: format!("of the {}", object.name),
        is_shown: |knob, values| {
            let hit = nearest(&OBJECTS, &pixel::ray(values));
            hit.is_some_and(|hit| knob.words.ends_with(hit.object.name))
        },
        ..Knob::new([symbol, "", ""], value(&object.material), range, steps)
    })
}

/// The picture of step 5: each term to switch off, a pixel to ask, and the material
/// of what it shows to set.
pub fn picture() -> Live {
    let mut all = pixel::knobs(470.0, 120.0);
    let terms = ["ambient", "diffuse", "specular"];
    all.extend(terms.map(|term| Knob::switch(term, true)));
    all.extend(knobs("n", |material| material.shininess.into(), [1.0, 300.0], 1.0));
    all.extend(knobs("Rₛ", |material| material.specular.x, [0.0, 1.0], 20.0));
    Live {
        knobs: all,
        handles: vec![pixel::cross()],
        numbers: |values| {
            let scene = scene(values);
            let shading = |ray: &Ray| shading(&scene, ray);
            let colour = |ray: &Ray| colour(&scene, ray);
            numbers(values, &scene.objects, shading, colour)
        },
        ..Live::new("step05_phong", |values| {
            shaded(&pixel::camera(values), &scene(values))
        })
    }
}
