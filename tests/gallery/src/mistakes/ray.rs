//! Mistakes with the rays themselves and the colour of their directions.

use crate::mistake::book;
use crate::{Mistake, Step, section};
use glam::DVec3;
use step01_rays::{Ray, direction_colour};

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "normalised",
        when: "V is normalised",
        sees: book(
            "The sky has less blue towards the corners, where its rays have been shortened.",
        ),
        says: "V stays as it comes out of the matrix, with a z of −1.",
        change: |parts| {
            parts.ray = |ray| Ray { direction: ray.direction.normalize(), ..ray };
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "parallel",
        when: "the ray starts at its pixel and goes straight ahead",
        sees: book(
            "The sky has one colour, and only what is right in front of the eye is seen, large.",
        ),
        says: "Every ray starts at C, and its pixel says where it goes.",
        change: |parts| {
            parts.ray = |ray| Ray { start: ray.at(1.0), direction: DVec3::NEG_Z };
        },
        ..section::RAY.mistake()
    },
    Mistake {
        name: "bare-direction",
        when: "the direction is the colour, without 0.7 + 0.3",
        sees: book(
            "The sky is a hard blue, with no red on the left and no green at the bottom.",
        ),
        says: "Directions have parts below 0, which no colour has: 0.7 + 0.3 V lifts them.",
        change: |parts| {
            parts.miss = |ray| ray.direction * DVec3::new(1.0, 1.0, -1.0)
        },
        ..section::DIRECTIONS.mistake()
    },
    Mistake {
        name: "blue-behind",
        step: Step::Sphere,
        when: "blue takes z, not −z",
        sees: book("The sky has too little blue: it is green and orange."),
        says: "Ahead is −z, so the blue grows with −z.",
        change: |parts| {
            parts.miss = |ray| {
                let direction = ray.direction * DVec3::new(1.0, 1.0, -1.0);
                direction_colour(&Ray { direction, ..*ray })
            };
        },
        ..section::DIRECTIONS.mistake()
    },
];
