use super::asked;
use crate::live::Knob;
use crate::scene::BALLS;
use glam::DVec3;
use std::ptr;
use step05_phong::{Light, Material, OBJECTS, Scene, nearest};

/// The shininess of each object, in their order.
pub const SHININESS: [Knob; 9] = [
    shininess::<0>("of the red sphere"),
    shininess::<1>("of the ground"),
    shininess::<2>("of the golden sphere"),
    shininess::<3>("of the blue sphere"),
    shininess::<4>("of the green sphere"),
    shininess::<5>("of the teal sphere"),
    shininess::<6>("of the white sphere"),
    shininess::<7>("of the salmon sphere"),
    shininess::<8>("of the cream sphere"),
];

/// How much of the light each mirrors, a grey.
pub const SPECULAR: [Knob; 9] = [
    specular::<0>(),
    specular::<1>(),
    specular::<2>(),
    specular::<3>(),
    specular::<4>(),
    specular::<5>(),
    specular::<6>(),
    specular::<7>(),
    specular::<8>(),
];

const fn shininess<const OBJECT: usize>(words: &'static str) -> Knob {
    let (.., value) = BALLS[OBJECT];
    let knob = Knob::new(["n", words, ""], value, [1.0, 300.0], 1.0);
    Knob { is_shown: is_asked::<OBJECT>, ..knob }
}

const fn specular<const OBJECT: usize>() -> Knob {
    let ((.., value, _), same) = (BALLS[OBJECT], SHININESS[OBJECT]);
    let knob = Knob::new(["Rₛ", same.words, ""], value, [0.0, 1.0], 20.0);
    Knob { is_shown: same.is_shown, ..knob }
}

/// Whether the pixel that is asked shows this object.
fn is_asked<const OBJECT: usize>(values: &[f64]) -> bool {
    let objects = OBJECTS;
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
