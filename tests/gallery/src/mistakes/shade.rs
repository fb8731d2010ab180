//! Mistakes with the ambient and the diffuse term, and with more than one light.

use crate::mistake::book;
use crate::{Mistake, section};
use glam::DVec3;
use step04_diffuse::{Surface, diffuse};

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "no-max",
        when: "l·n may be below 0",
        sees: book(
            "The side that faces away from a light is too dark, down to black.",
        ),
        says: "max(l·n, 0): a light behind the surface gives nothing, and takes nothing away.",
        change: |parts| {
            parts.diffuse = |n, l, d, surface, light| {
                surface.diffuse / light.attenuation.at(d) * l.dot(n) * light.diffuse
            };
        },
        ..section::LAMBERT.mistake()
    },
    Mistake {
        name: "absolute",
        when: "|n·l| is taken for max(n·l, 0)",
        sees: book("The dark sides are lit as well, as if by lights behind them."),
        says: "A light behind the surface does not reach it.",
        change: |parts| {
            parts.diffuse = |n, l, d, surface, light| {
                let cosine = l.dot(n).abs();
                surface.diffuse / light.attenuation.at(d) * cosine * light.diffuse
            };
        },
        ..section::LAMBERT.mistake()
    },
    Mistake {
        name: "no-cosine",
        when: "l·n is left out of the diffuse term",
        sees: book("Spheres are flat discs again, only brighter."),
        says: "By Lambert's law, light that comes in at a slant counts l·n times.",
        change: |parts| {
            parts.diffuse = |_, _, d, surface, light| {
                surface.diffuse / light.attenuation.at(d) * light.diffuse
            };
        },
        ..section::DIFFUSE.mistake()
    },
    Mistake {
        name: "no-colour",
        when: "R_d is left out of the diffuse term",
        sees: book(
            "The lit sides have the colour of the light, not that of the sphere.",
        ),
        says: "The surface reflects only R_d of the light, in each of red, green and blue.",
        change: |parts| {
            parts.diffuse = |n, l, d, _, light| {
                diffuse(n, l, d, &Surface::of(DVec3::ONE), light)
            };
        },
        ..section::DIFFUSE.mistake()
    },
    Mistake {
        name: "no-diffuse",
        when: "the diffuse term is left out",
        sees: book("Spheres are flat discs again, and dark."),
        says: "I is the sum of all its terms: each light adds its I_d.",
        change: |parts| parts.diffuse = |_, _, _, _, _| DVec3::ZERO,
        ..section::LIGHTS.mistake()
    },
    Mistake {
        name: "no-ambient",
        when: "the ambient term is left out",
        sees: book("What no light reaches is black."),
        says: "The sum begins with I_a = R_a L_a.",
        change: |parts| parts.scene.ambient_light = DVec3::ZERO,
        ..section::AMBIENT.mistake()
    },
    Mistake {
        name: "ambient-without-colour",
        when: "R_a is left out of the ambient term",
        sees: book("Everything is pale, and the dark sides are one bluish grey."),
        says: "The surface reflects only R_a of the ambient light, in its own colour.",
        change: |parts| {
            parts.materials().for_each(|m| m.surface.ambient = DVec3::ONE);
        },
        ..section::AMBIENT.mistake()
    },
    Mistake {
        name: "ambient-per-light",
        when: "the ambient term is added for each light",
        sees: book("Everything is too bright, the dark sides most of all."),
        says: "I_a belongs to no light: it stands before the loop, and counts once.",
        change: |parts| parts.scene.ambient_light *= 2.0,
        ..section::LIGHTS.mistake()
    },
    Mistake {
        name: "first-light-only",
        when: "only the first light counts",
        sees: book("The right sides of the spheres have lost their bluish light."),
        says: "The sum runs over all lights.",
        change: |parts| parts.scene.lights.truncate(1),
        ..section::LIGHTS.mistake()
    },
    Mistake {
        name: "last-light-only",
        when: "only the last light counts",
        sees: book("Only the cool light is left, on the right sides."),
        says: "Add to the sum with `+=`: `=` forgets what was there before.",
        change: |parts| drop(parts.scene.lights.drain(..1)),
        ..section::LIGHTS.mistake()
    },
    Mistake {
        name: "averaged",
        when: "the light is divided by the number of lights",
        sees: book("Everything that is lit is too dark."),
        says: "Light adds up: two lamps are brighter than one.",
        change: |parts| {
            let count = parts.scene.lights.len() as f64;
            for light in &mut parts.scene.lights {
                light.point_light.diffuse /= count;
                light.specular /= count;
            }
        },
        ..section::LIGHTS.mistake()
    },
];
