//! A scene that is its reader's own: everything in it can be set, and it says its Rust.

mod address;
mod knobs;
mod rust;

pub use address::opened;

use crate::live::{Handle, Live, named};
use crate::pictures::pixel::{self, SIZE};
use crate::pictures::{shaded, step01};
use glam::{DVec2, DVec3};
use knobs::{AMBIENT, FIELD_OF_VIEW, KNOBS, LIGHT, LIGHTS, SPHERE, SPHERES};
use step05_phong::{
    Attenuation, Camera, Light, Material, Matte, Object, PointLight, Scene, Sphere,
};

/// The camera, whose picture has so many columns.
fn camera(values: &[f64], columns: f64) -> Camera {
    step01::camera(&[values[FIELD_OF_VIEW], 1.0, columns])
}

/// What is in the reader's own scene, and the light to see it in.
pub fn own_scene(values: &[f64]) -> Scene<Material, Light> {
    // The first number of a thing is a switch.
    let is_there = |thing: &&[f64]| thing[0] == 1.0;
    let objects = (SPHERES..LIGHTS).step_by(SPHERE);
    let lights = values[LIGHTS..].chunks(LIGHT);
    Scene {
        objects: objects
            .filter(|&first| values[first] == 1.0)
            .map(|first| object(KNOBS[first].group, &values[first..]))
            .collect(),
        ambient_light: DVec3::from_slice(&values[AMBIENT..]),
        lights: lights.filter(is_there).map(light).collect(),
    }
}

fn object(name: &'static str, values: &[f64]) -> Object<Material> {
    let centre = DVec3::from_slice(&values[1..]);
    let matte = Matte::of(DVec3::from_slice(&values[7..]));
    let (specular, shininess) = (DVec3::splat(values[5]), values[6] as i32);
    Object {
        name,
        sphere: Sphere { centre, radius: values[4] },
        material: Material { matte, specular, shininess },
    }
}

fn light(values: &[f64]) -> Light {
    let [a, b, c] = [values[10], values[11], values[12]];
    let point_light = PointLight {
        position: DVec3::from_slice(&values[1..]),
        diffuse: DVec3::from_slice(&values[4..]),
        attenuation: Attenuation { a, b, c },
    };
    Light { point_light, specular: DVec3::from_slice(&values[7..]) }
}

/// The place of a thing whose numbers begin there; left of the picture where it is left
/// out. It stays as deep as it is.
fn handle(first: usize) -> Handle {
    Handle::new(
        KNOBS[first].group,
        [first + 1, first + 2],
        |handle, values| {
            let x = handle.knobs[0];
            match values[x - 1] {
                0.0 => DVec2::NEG_X,
                _ => pixel::place(
                    &camera(values, SIZE.x),
                    DVec3::from_slice(&values[x..]),
                ),
            }
        },
        |handle, values, to| {
            let (camera, z) = (camera(values, SIZE.x), values[handle.knobs[1] + 1]);
            pixel::point(&camera, to.clamp(DVec2::ZERO, SIZE), z)
        },
    )
}

/// The picture of step 5, with everything in it to set, and its Rust.
pub fn live() -> Live {
    let spheres = (SPHERES..LIGHTS).step_by(SPHERE);
    let things = spheres.chain((LIGHTS..KNOBS.len()).step_by(LIGHT));
    Live {
        knobs: KNOBS.clone(),
        handles: things.map(handle).collect(),
        numbers: |values| {
            named([
                ("rust", rust::text(&own_scene(values), values[FIELD_OF_VIEW])),
                ("address", address::address(&KNOBS, values)),
            ])
        },
        ..Live::new("own_scene", |values| {
            shaded(&camera(values, values[0]), &own_scene(values))
        })
    }
}
