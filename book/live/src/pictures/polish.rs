use super::asked;
use crate::live::Knob;
use glam::DVec3;
use std::ptr;
use step05_phong::{Light, Material, Scene, nearest, objects};

/// The shininess of each object, in their order.
pub const SHININESS: [Knob; 9] = [
    shininess::<0>("of the red sphere", 40.0),
    shininess::<1>("of the ground", 10.0),
    shininess::<2>("of the golden sphere", 150.0),
    shininess::<3>("of the blue sphere", 30.0),
    shininess::<4>("of the green sphere", 30.0),
    shininess::<5>("of the teal sphere", 16.0),
    shininess::<6>("of the white sphere", 300.0),
    shininess::<7>("of the salmon sphere", 40.0),
    shininess::<8>("of the cream sphere", 20.0),
];

/// How much of the light each mirrors, a grey.
pub const SPECULAR: [Knob; 9] = [
    specular(SHININESS[0], 0.7),
    specular(SHININESS[1], 0.15),
    specular(SHININESS[2], 0.8),
    specular(SHININESS[3], 0.4),
    specular(SHININESS[4], 0.5),
    specular(SHININESS[5], 0.6),
    specular(SHININESS[6], 0.9),
    specular(SHININESS[7], 0.5),
    specular(SHININESS[8], 0.4),
];

const fn shininess<const OBJECT: usize>(words: &'static str, value: f64) -> Knob {
    let knob = Knob::new(["n", words, ""], value, [1.0, 300.0], 1.0);
    Knob { is_shown: is_asked::<OBJECT>, ..knob }
}

const fn specular(same: Knob, value: f64) -> Knob {
    let knob = Knob::new(["Rₛ", same.words, ""], value, [0.0, 1.0], 20.0);
    Knob { is_shown: same.is_shown, ..knob }
}

/// Whether the pixel that is asked shows this object.
fn is_asked<const OBJECT: usize>(values: &[f64]) -> bool {
    let objects = objects();
    let hit = nearest(&objects, &asked::ray(values));
    hit.is_some_and(|hit| ptr::eq(hit.object, &objects[OBJECT]))
}

/// The scene of step 5, of nine numbers n and then nine R_s.
pub fn scene(values: &[f64]) -> Scene<Material, Light> {
    let mut scene = step05_phong::scene();
    let values = values[..9].iter().zip(&values[9..]);
    for (object, (n, r_s)) in scene.objects.iter_mut().zip(values) {
        object.material.shininess = *n as i32;
        object.material.specular = DVec3::splat(*r_s);
    }
    scene
}
