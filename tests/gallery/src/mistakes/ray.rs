//! Mistakes with the rays themselves and the colour of their directions.

use crate::{Mistake, Parts, Section, Step, section};
use glam::DVec3;
use step01_rays::{Ray, direction_colour};

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        Step::Rays,
        "normalised",
        "V is normalised",
        "The sky is darker towards the corners, where its rays have been shortened.",
        "V stays as it comes out of the matrix, with a z of −1.",
        ("steps/step01_rays/src/camera.rs", section::CAMERA),
        |parts| {
            parts.ray = |ray| Ray { direction: ray.direction.normalize(), ..ray };
        },
    ),
    wrong(
        Step::Rays,
        "parallel",
        "the ray starts at its pixel and goes straight ahead",
        "The sky has one colour, and only what is right before the eye is seen, large.",
        "Every ray starts at C, and its pixel says where it goes.",
        ("steps/step01_rays/src/ray.rs", section::RAY),
        |parts| {
            parts.ray = |ray| Ray { start: ray.at(1.0), direction: DVec3::NEG_Z };
        },
    ),
    wrong(
        Step::Rays,
        "bare-direction",
        "the direction is the colour, without 0.7 + 0.3",
        "The sky is a hard blue, with no red on the left and no green at the bottom.",
        "Directions have parts below 0, which no colour has: 0.7 + 0.3 V lifts them.",
        ("steps/step01_rays/src/picture.rs", section::DIRECTIONS),
        |parts| parts.miss = |ray| ray.direction * DVec3::new(1.0, 1.0, -1.0),
    ),
    wrong(
        Step::Sphere,
        "blue-behind",
        "blue takes z, not −z",
        "The sky has too little blue: it is green and pink.",
        "Ahead is −z, so the blue grows with −z.",
        ("steps/step01_rays/src/picture.rs", section::DIRECTIONS),
        |parts| {
            parts.miss = |ray| {
                let direction = ray.direction * DVec3::new(1.0, 1.0, -1.0);
                direction_colour(&Ray { direction, ..*ray })
            };
        },
    ),
];

const fn wrong(
    step: Step,
    name: &'static str,
    when: &'static str,
    sees: &'static str,
    says: &'static str,
    (file, section): (&'static str, Section),
    change: fn(&mut Parts),
) -> Mistake {
    Mistake { name, step, file, section, when, sees, says, change }
}
