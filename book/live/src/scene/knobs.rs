//! The numbers of a scene, one after the other: the camera, the ambient light, the
//! spheres, the lights.

use super::things::{BALLS, Ball, LAMPS, Lamp};
use crate::live::Knob;
use crate::pictures::asked;
use step05_phong::{Attenuation, PointLight};

/// How many numbers a sphere has.
pub const SPHERE: usize = 10;

/// How many numbers a light has.
pub const LIGHT: usize = 13;

/// The place of the field of view.
pub const FIELD_OF_VIEW: usize = 1;

/// The place of L_a.
pub const AMBIENT: usize = 2;

/// The place of the first sphere.
pub const SPHERES: usize = 5;

/// The place of the first light.
pub const LIGHTS: usize = SPHERES + SPHERE * BALLS.len();

/// Every number of a scene.
pub static KNOBS: [Knob; LIGHTS + LIGHT * LAMPS.len()] = {
    let mut knobs = [asked::COLUMNS; LIGHTS + LIGHT * LAMPS.len()];
    knobs[FIELD_OF_VIEW] =
        Knob::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0)
            .of("camera");
    let colour = colour(["red", "green", "blue"], [0.32, 0.32, 0.42], 1.0);
    put(&mut knobs, AMBIENT, "ambient light", &colour);
    let mut k = 0;
    while k < BALLS.len() {
        put(&mut knobs, SPHERES + SPHERE * k, BALLS[k].0, &ball(&BALLS[k]));
        k += 1;
    }
    let mut k = 0;
    while k < LAMPS.len() {
        put(&mut knobs, LIGHTS + LIGHT * k, LAMPS[k].0, &lamp(&LAMPS[k]));
        k += 1;
    }
    knobs
};

const SWITCH: &[&str] = &["off", "on"];

const fn ball(&(_, is_there, centre, r, paint, r_s, n): &Ball) -> [Knob; SPHERE] {
    let (around, radius) = if r < 10.0 {
        ([[-6.0, 6.0], [-3.0, 5.0], [-16.0, 6.0]], [0.05, 3.0])
    } else {
        ([[-20.0, 20.0], [-60.0, 0.0], [-30.0, 10.0]], [10.0, 60.0])
    };
    let [x, y, z] = place(centre, around);
    let [red, green, blue] = colour(["red", "green", "blue"], paint, 1.0);
    [
        Knob::choice("in the scene", is_there, SWITCH),
        x,
        y,
        z,
        Knob::new(["r", "radius", ""], r, radius, 100.0),
        Knob::new(["Rₛ", "mirrored", ""], r_s, [0.0, 1.0], 100.0),
        Knob::new(["n", "shininess", ""], n, [1.0, 300.0], 1.0),
        red,
        green,
        blue,
    ]
}

const fn lamp(&(_, is_on, light): &Lamp) -> [Knob; LIGHT] {
    let PointLight { position, diffuse, attenuation } = light.point_light;
    let Attenuation { a, b, c } = attenuation;
    let around = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]];
    let [x, y, z] = place(position.to_array(), around);
    let [red, green, blue] =
        colour(["red", "green", "blue"], diffuse.to_array(), 2.0);
    let words = ["red in highlights", "green in highlights", "blue in highlights"];
    let [s_red, s_green, s_blue] = colour(words, light.specular.to_array(), 2.0);
    [
        Knob::choice("on", is_on, SWITCH),
        x,
        y,
        z,
        red,
        green,
        blue,
        s_red,
        s_green,
        s_blue,
        // Above 0, so that a + bd + cd² is.
        Knob::new(["a", "constant fading", ""], a, [0.1, 2.0], 100.0),
        Knob::new(["b", "linear fading", ""], b, [0.0, 1.0], 1000.0),
        Knob::new(["c", "quadratic fading", ""], c, [0.0, 1.0], 1000.0),
    ]
}

const fn place(at: [f64; 3], around: [[f64; 2]; 3]) -> [Knob; 3] {
    [
        Knob::new(["x", "sideways", ""], at[0], around[0], 100.0),
        Knob::new(["y", "upwards", ""], at[1], around[1], 100.0),
        Knob::new(["z", "towards you", ""], at[2], around[2], 100.0),
    ]
}

const fn colour(words: [&'static str; 3], rgb: [f64; 3], most: f64) -> [Knob; 3] {
    [
        Knob::new(["", words[0], ""], rgb[0], [0.0, most], 100.0),
        Knob::new(["", words[1], ""], rgb[1], [0.0, most], 100.0),
        Knob::new(["", words[2], ""], rgb[2], [0.0, most], 100.0),
    ]
}

/// Puts the numbers of a thing of this name in their places.
const fn put(knobs: &mut [Knob], from: usize, name: &'static str, of: &[Knob]) {
    let mut k = 0;
    while k < of.len() {
        knobs[from + k] = of[k].of(name);
        k += 1;
    }
}
