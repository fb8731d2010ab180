//! A scene that is its reader's own: everything in it can be set, and it says its Rust.

mod knobs;
mod literal;
mod rust;
mod things;

use crate::address::address;
use crate::live::{Handle, Live};
use crate::pictures::asked::{SIZE, place_by};
use crate::pictures::{lit, step01};
use glam::{DVec2, DVec3};
use knobs::{AMBIENT, FIELD_OF_VIEW, KNOBS, LIGHT, LIGHTS, SPHERE, SPHERES};
use step05_phong::{
    Attenuation, Camera, Light, Material, Object, PointLight, Scene, Sphere,
    Surface,
};
pub(crate) use things::BALLS;
use things::LAMPS;

/// The picture of step 5, with everything in it to set, and its Rust.
pub const OWN_SCENE: Live = Live {
    name: "own_scene",
    knobs: &KNOBS,
    handles: &[
        ball::<0>(),
        ball::<1>(),
        ball::<2>(),
        ball::<3>(),
        ball::<4>(),
        ball::<5>(),
        ball::<6>(),
        ball::<7>(),
        ball::<8>(),
        ball::<9>(),
        ball::<10>(),
        ball::<11>(),
        lamp::<0>(),
        lamp::<1>(),
        lamp::<2>(),
    ],
    is_allowed: |values| camera(values).is_ok(),
    sight: |values| {
        let camera = camera(values).unwrap_or_else(|_| crate::camera());
        lit(&camera, &own_scene(values))
    },
    numbers: |values| {
        let rust = rust::text(&own_scene(values), values[FIELD_OF_VIEW]);
        let address = address(&KNOBS, values);
        vec![("rust".into(), rust), ("address".into(), address)]
    },
    beside: None,
};

/// The camera, whose picture has the columns that the values say.
fn camera(values: &[f64]) -> Result<Camera, String> {
    step01::camera(&[values[FIELD_OF_VIEW], 1.0, values[0]])
}

/// What is in the reader's own scene, and the light to see it in.
pub fn own_scene(values: &[f64]) -> Scene<Material, Light> {
    let objects = values[SPHERES..LIGHTS].chunks(SPHERE);
    let lights = values[LIGHTS..].chunks(LIGHT);
    Scene {
        objects: objects.filter(is_there).map(object).collect(),
        ambient_light: DVec3::from_slice(&values[AMBIENT..]),
        lights: lights.filter(is_there).map(light).collect(),
    }
}

/// The first number of a thing is a switch.
fn is_there(values: &&[f64]) -> bool {
    values[0] == 1.0
}

fn object(values: &[f64]) -> Object<Material> {
    let centre = DVec3::from_slice(&values[1..]);
    let surface = Surface::of(DVec3::from_slice(&values[7..]));
    let (specular, shininess) = (DVec3::splat(values[5]), values[6] as i32);
    Object {
        sphere: Sphere { centre, radius: values[4] },
        material: Material { surface, specular, shininess },
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

const fn ball<const K: usize>() -> Handle {
    let x = SPHERES + SPHERE * K + 1;
    let at = |values: &[f64]| place(values, SPHERES + SPHERE * K);
    let drag = |values: &mut [f64], to| drag(values, SPHERES + SPHERE * K, to);
    Handle::new(BALLS[K].0, [x, x + 1], at, drag)
}

const fn lamp<const K: usize>() -> Handle {
    let x = LIGHTS + LIGHT * K + 1;
    let at = |values: &[f64]| place(values, LIGHTS + LIGHT * K);
    let drag = |values: &mut [f64], to| drag(values, LIGHTS + LIGHT * K, to);
    Handle::new(LAMPS[K].0, [x, x + 1], at, drag)
}

/// The camera of the page.
fn page(values: &[f64]) -> Camera {
    let camera = step01::camera(&[values[FIELD_OF_VIEW], 1.0, SIZE.x]);
    camera.unwrap_or_else(|_| crate::camera())
}

/// Where in the picture a thing is whose numbers begin here; left of it where it is
/// left out.
fn place(values: &[f64], from: usize) -> DVec2 {
    match is_there(&&values[from..]) {
        true => place_by(&page(values), DVec3::from_slice(&values[from + 1..])),
        false => DVec2::NEG_X,
    }
}

/// Brings that thing to a place in the picture; it stays as deep as it is.
fn drag(values: &mut [f64], from: usize, to: DVec2) {
    let pixel = to.clamp(DVec2::ZERO, SIZE) - 0.5;
    let ray = page(values).ray(pixel.x, pixel.y);
    let position = ray.at(-values[from + 3]);
    values[from + 1..from + 3].copy_from_slice(&position.truncate().to_array());
}
