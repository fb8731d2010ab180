use crate::live::Knob;
use crate::pictures::pixel;
use glam::DVec3;
use std::sync::LazyLock;
use step05_phong::{
    Attenuation, Light, OBJECTS, Object, PointLight, Sphere, scene,
};

/// How many numbers a sphere has, and a light.
pub const SPHERE: usize = 10;
pub const LIGHT: usize = 13;

/// The places of the field of view, of L_a, of the first sphere and of the first light.
pub const FIELD_OF_VIEW: usize = 1;
pub const AMBIENT: usize = 2;
pub const SPHERES: usize = 5;
pub const LIGHTS: usize = SPHERES + SPHERE * (OBJECTS.len() + 3);

/// The numbers of a scene, one after the other: the camera, the ambient light, the
/// spheres, the lights. Three spheres and a light are left out at first.
pub static KNOBS: LazyLock<Vec<Knob>> = LazyLock::new(|| {
    let scene = scene();
    let mut knobs = vec![pixel::columns()];
    let mut put = |group, all: Vec<Knob>| {
        knobs.extend(all.into_iter().map(|knob| Knob { group, ..knob }));
    };
    let angle = Knob::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0);
    put("camera", vec![angle]);
    put("ambient light", colour(RGB, scene.ambient_light.into(), 1.0).into());
    for Object { name, sphere, material } in scene.objects {
        let Sphere { centre, radius } = sphere;
        let colour = material.matte.diffuse.into();
        let (r_s, n) = (material.specular.x, material.shininess.into());
        put(name, ball(true, centre.into(), radius, colour, r_s, n));
    }
    let more = ball(false, [1.25, -1.1, -5.0], 0.35, [0.45, 0.2, 0.6], 0.8, 80.0);
    put("tenth sphere", more);
    let more = ball(false, [-1.2, 1.6, -7.0], 0.4, [0.1, 0.3, 0.75], 0.6, 60.0);
    put("eleventh sphere", more);
    let more = ball(false, [1.6, 1.7, -8.0], 0.45, [0.85, 0.15, 0.35], 0.3, 20.0);
    put("twelfth sphere", more);
    for (name, one) in ["warm light", "cool light"].into_iter().zip(scene.lights) {
        put(name, light(&one, true));
    }
    put("third light", light(&ROSE, false));
    knobs
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

/// The numbers of a sphere; those of the ground reach further.
fn ball(
    is_there: bool,
    centre: [f64; 3],
    radius: f64,
    rgb: [f64; 3],
    r_s: f64,
    n: f64,
) -> Vec<Knob> {
    let (around, radii) = if radius < 10.0 {
        ([[-6.0, 6.0], [-3.0, 5.0], [-16.0, 6.0]], [0.05, 3.0])
    } else {
        ([[-20.0, 20.0], [-60.0, 0.0], [-30.0, 10.0]], [10.0, 60.0])
    };
    let mut knobs = vec![Knob::switch("in the scene", is_there)];
    knobs.extend(place(centre, around));
    knobs.extend([
        Knob::new(["r", "radius", ""], radius, radii, 100.0),
        Knob::new(["Rₛ", "mirrored", ""], r_s, [0.0, 1.0], 100.0),
        Knob::new(["n", "shininess", ""], n, [1.0, 300.0], 1.0),
    ]);
    knobs.extend(colour(RGB, rgb, 1.0));
    knobs
}

/// The numbers of a light.
fn light(light: &Light, is_on: bool) -> Vec<Knob> {
    let PointLight { position, diffuse, attenuation } = light.point_light;
    let Attenuation { a, b, c } = attenuation;
    let around = [[-12.0, 12.0], [-6.0, 12.0], [-20.0, 6.0]];
    let words = ["red in highlights", "green in highlights", "blue in highlights"];
    let mut knobs = vec![Knob::switch("on", is_on)];
    knobs.extend(place(position.into(), around));
    knobs.extend(colour(RGB, diffuse.into(), 2.0));
    knobs.extend(colour(words, light.specular.into(), 2.0));
    knobs.extend([
        // Above 0, so that a + bd + cd² is.
        Knob::new(["a", "constant fading", ""], a, [0.1, 2.0], 100.0),
        Knob::new(["b", "linear fading", ""], b, [0.0, 1.0], 1000.0),
        Knob::new(["c", "quadratic fading", ""], c, [0.0, 1.0], 1000.0),
    ]);
    knobs
}

fn place([x, y, z]: [f64; 3], around: [[f64; 2]; 3]) -> [Knob; 3] {
    [
        Knob::new(["x", "sideways", ""], x, around[0], 100.0),
        Knob::new(["y", "upwards", ""], y, around[1], 100.0),
        Knob::new(["z", "towards you", ""], z, around[2], 100.0),
    ]
}

const RGB: [&str; 3] = ["red", "green", "blue"];

fn colour(words: [&'static str; 3], rgb: [f64; 3], most: f64) -> [Knob; 3] {
    [0, 1, 2].map(|k| Knob::new(["", words[k], ""], rgb[k], [0.0, most], 100.0))
}
