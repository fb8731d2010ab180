//! The parameters of the reader's own scene, one after the other: the camera, the ambient
//! light, the way back, the spheres, the lights. Three spheres and a light are left out at
//! first, and so are shadows and mirrors.

use crate::Parameter;
use crate::parameter::array;
use crate::probe::columns_parameter;
use course::Settings;
use course::examples::mirror::{Mirror, mirrors};
use glam::DVec3;
use std::slice::ChunksExact;
use std::sync::LazyLock;
use step05_phong::{Attenuation, Light, OBJECTS, Object, PointLight, Scene, Sphere};

/// The number of parameters of the settings, of a sphere, and of a light.
pub const SETTINGS: usize = 13;
pub const SPHERE: usize = 11;
pub const LIGHT: usize = 13;

/// The number of spheres.
pub const SPHERES: usize = OBJECTS.len() + 3;

/// The parameters, or their values, of the settings, of each sphere, and of each light.
pub fn split_parameters<T>(parameters: &[T]) -> (&[T], ChunksExact<'_, T>, ChunksExact<'_, T>) {
    let (settings, objects) = parameters.split_at(SETTINGS);
    let (spheres, lights) = objects.split_at(SPHERES * SPHERE);
    (settings, spheres.chunks_exact(SPHERE), lights.chunks_exact(LIGHT))
}

/// The settings of these values of all parameters.
pub fn settings(values: &[f64]) -> Settings {
    let [columns, fov_degrees, x, y, z, target @ .., roll_degrees] = array::<9>(&values[..9]);
    let (position, target) = (DVec3::new(x, y, z), target.into());
    let has_mirrors = values[12] == 1.0;
    Settings { columns, fov_degrees, position, target, roll_degrees, has_mirrors }
}

/// L_a of these values of all parameters.
pub fn ambient_light(values: &[f64]) -> DVec3 {
    DVec3::from_slice(&values[9..])
}

/// All parameters.
pub static PARAMETERS: LazyLock<Vec<Parameter>> = LazyLock::new(|| {
    let Scene { objects, ambient_light, lights } = mirrors();
    let mut parameters = vec![columns_parameter()];
    let mut add_group = |group, members: Vec<Parameter>| {
        let members = members.into_iter();
        parameters.extend(members.map(|member| Parameter { group, ..member }));
    };
    add_group("camera", camera_parameters());
    add_group("ambient light", colour(RGB, ambient_light.into(), 1.0).into());
    let switch = Parameter::switch("shadows and mirrors", false);
    add_group("the way back", vec![switch]);
    for Object { name, sphere, material: Mirror { material, k } } in objects {
        let colour = material.matte.diffuse.into();
        let shine = [material.specular.x, material.shininess.into()];
        add_group(name, sphere_parameters(true, sphere, colour, shine, k));
    }
    let sphere_at = |x, y, z, radius| Sphere { centre: DVec3::new(x, y, z), radius };
    let sphere = sphere_at(1.25, -1.1, -5.0, 0.35);
    let more = sphere_parameters(false, sphere, [0.45, 0.2, 0.6], [0.8, 80.0], 0.5);
    add_group("tenth sphere", more);
    let sphere = sphere_at(-1.2, 1.6, -7.0, 0.4);
    let more = sphere_parameters(false, sphere, [0.1, 0.3, 0.75], [0.6, 60.0], 0.3);
    add_group("eleventh sphere", more);
    let sphere = sphere_at(1.6, 1.7, -8.0, 0.45);
    let more = sphere_parameters(false, sphere, [0.85, 0.15, 0.35], [0.3, 20.0], 0.1);
    add_group("twelfth sphere", more);
    for (name, light) in ["warm light", "cool light"].into_iter().zip(lights) {
        add_group(name, light_parameters(&light, true));
    }
    add_group("third light", light_parameters(&ROSE, false));
    parameters
});

/// A light among the spheres.
const ROSE: Light = Light {
    point_light: PointLight {
        position: DVec3::new(0.3, 1.5, -5.0),
        diffuse: DVec3::new(0.9, 0.3, 0.6),
        attenuation: Attenuation { a: 0.6, b: 0.0, c: 0.1 },
    },
    specular: DVec3::new(1.0, 0.6, 0.8),
};

/// The parameters of the camera.
fn camera_parameters() -> Vec<Parameter> {
    let number =
        |symbol, words, default, range| Parameter::new([symbol, words, ""], default, range, 100.0);
    vec![
        Parameter::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
        number("x", "position sideways", 0.0, [-12.0, 12.0]),
        number("y", "position upwards", 0.0, [-6.0, 12.0]),
        number("z", "position backwards", 0.0, [-20.0, 12.0]),
        number("x", "target sideways", 0.0, [-12.0, 12.0]),
        number("y", "target upwards", 0.0, [-6.0, 12.0]),
        number("z", "target backwards", -1.0, [-20.0, 12.0]),
        Parameter::new(["", "roll", "°"], 0.0, [-180.0, 180.0], 1.0),
    ]
}

/// The parameters of a sphere; those of the ground have larger ranges.
fn sphere_parameters(
    is_there: bool,
    sphere: Sphere,
    rgb: [f64; 3],
    [r_s, n]: [f64; 2],
    k: f64,
) -> Vec<Parameter> {
    let Sphere { centre, radius } = sphere;
    let (ranges, radii) = if radius < 10.0 {
        ([[-6.0, 6.0], [-3.0, 5.0], [-16.0, 6.0]], [0.05, 3.0])
    } else {
        ([[-20.0, 20.0], [-60.0, 0.0], [-30.0, 10.0]], [10.0, 60.0])
    };
    let mut parameters = vec![Parameter::switch("in the scene", is_there)];
    parameters.extend(position(centre.into(), ranges));
    parameters.extend([
        Parameter::new(["r", "radius", ""], radius, radii, 100.0),
        Parameter::new(["Rₛ", "mirrored", ""], r_s, [0.0, 1.0], 100.0),
        Parameter::new(["n", "shininess", ""], n, [1.0, 300.0], 1.0),
    ]);
    parameters.extend(colour(RGB, rgb, 1.0));
    parameters.push(Parameter {
        has_control: |_, values| settings(values).has_mirrors,
        ..Parameter::new(["k", "mirror image", ""], k, [0.0, 1.0], 100.0)
    });
    parameters
}

/// The parameters of a light.
fn light_parameters(light: &Light, is_on: bool) -> Vec<Parameter> {
    let PointLight { position: place, diffuse, attenuation } = light.point_light;
    let Attenuation { a, b, c } = attenuation;
    let ranges = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]];
    let words = ["red in highlights", "green in highlights", "blue in highlights"];
    let mut parameters = vec![Parameter::switch("on", is_on)];
    parameters.extend(position(place.into(), ranges));
    parameters.extend(colour(RGB, diffuse.into(), 2.0));
    parameters.extend(colour(words, light.specular.into(), 2.0));
    parameters.extend([
        // Above 0, so that a + bd + cd² is.
        Parameter::new(["a", "constant fading", ""], a, [0.1, 2.0], 100.0),
        Parameter::new(["b", "linear fading", ""], b, [0.0, 1.0], 1000.0),
        Parameter::new(["c", "quadratic fading", ""], c, [0.0, 1.0], 1000.0),
    ]);
    parameters
}

/// The three coordinates of a position.
fn position([x, y, z]: [f64; 3], ranges: [[f64; 2]; 3]) -> [Parameter; 3] {
    [
        Parameter::new(["x", "sideways", ""], x, ranges[0], 100.0),
        Parameter::new(["y", "upwards", ""], y, ranges[1], 100.0),
        Parameter::new(["z", "towards you", ""], z, ranges[2], 100.0),
    ]
}

const RGB: [&str; 3] = ["red", "green", "blue"];

/// The three channels of a colour, each from 0 to `max`.
fn colour(words: [&'static str; 3], rgb: [f64; 3], max: f64) -> [Parameter; 3] {
    [0, 1, 2].map(|k| Parameter::new(["", words[k], ""], rgb[k], [0.0, max], 100.0))
}
