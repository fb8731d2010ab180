//! The numbers of a scene, one after the other: the camera, the ambient light, the
//! spheres, the lights.

use crate::live::Knob;
use crate::pictures::asked;

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
pub const KNOBS: [Knob; LIGHTS + LIGHT * LAMPS.len()] = {
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

/// Name, 1 if it is in the scene, centre, radius, colour, R_s and n of a sphere.
type Ball = (&'static str, f64, [f64; 3], f64, [f64; 3], f64, f64);

/// The nine of the course, and three that are left out at first.
pub const BALLS: [Ball; 12] = [
    ("red sphere", 1.0, [-0.65, -0.16, -7.4], 1.2, [0.91, 0.34, 0.28], 0.7, 40.0),
    ("ground", 1.0, [0.0, -41.2, -11.0], 40.0, [0.80, 0.76, 0.82], 0.15, 10.0),
    (
        "golden sphere",
        1.0,
        [0.45, -1.12, -5.8],
        0.42,
        [0.99, 0.76, 0.32],
        0.8,
        150.0,
    ),
    ("blue sphere", 1.0, [-3.0, -0.02, -10.2], 1.3, [0.44, 0.47, 0.78], 0.4, 30.0),
    ("green sphere", 1.0, [0.3, 0.4, 4.0], 1.2, [0.00, 1.00, 0.00], 0.5, 30.0),
    ("teal sphere", 1.0, [3.3, -0.69, -6.4], 0.9, [0.16, 0.60, 0.60], 0.6, 16.0),
    (
        "white sphere",
        1.0,
        [-2.05, -1.05, -6.1],
        0.5,
        [0.97, 0.94, 0.90],
        0.9,
        300.0,
    ),
    (
        "salmon sphere",
        1.0,
        [1.55, 0.42, -10.8],
        1.65,
        [0.96, 0.66, 0.56],
        0.5,
        40.0,
    ),
    ("cream sphere", 1.0, [-2.1, 2.3, -9.5], 0.34, [0.99, 0.87, 0.62], 0.4, 20.0),
    ("tenth sphere", 0.0, [1.25, -1.1, -5.0], 0.35, [0.45, 0.20, 0.60], 0.8, 80.0),
    ("eleventh sphere", 0.0, [-1.2, 1.6, -7.0], 0.4, [0.10, 0.30, 0.75], 0.6, 60.0),
    ("twelfth sphere", 0.0, [1.6, 1.7, -8.0], 0.45, [0.85, 0.15, 0.35], 0.3, 20.0),
];

/// Name, 1 if it is on, position, L_d, L_s, and a, b and c of a light.
type Lamp = (&'static str, f64, [f64; 3], [f64; 3], [f64; 3], [f64; 3]);

/// The two of the course, and one that is off at first.
pub const LAMPS: [Lamp; 3] = [
    (
        "warm light",
        1.0,
        [-4.0, 5.0, -2.0],
        [1.0, 0.84, 0.64],
        [1.0, 0.9, 0.8],
        [0.7, 0.02, 0.005],
    ),
    (
        "cool light",
        1.0,
        [5.5, 2.2, -11.5],
        [0.45, 0.6, 1.0],
        [0.5, 0.7, 1.0],
        [0.5, 0.0, 0.02],
    ),
    (
        "third light",
        0.0,
        [0.3, 1.5, -5.0],
        [0.9, 0.3, 0.6],
        [1.0, 0.6, 0.8],
        [0.6, 0.0, 0.1],
    ),
];

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

const fn lamp(&(_, is_on, at, l_d, l_s, [a, b, c]): &Lamp) -> [Knob; LIGHT] {
    let [x, y, z] = place(at, [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]]);
    let [red, green, blue] = colour(["red", "green", "blue"], l_d, 2.0);
    let words = ["red in highlights", "green in highlights", "blue in highlights"];
    let [s_red, s_green, s_blue] = colour(words, l_s, 2.0);
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
