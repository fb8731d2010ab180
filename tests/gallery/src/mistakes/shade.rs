//! Mistakes with the ambient and the diffuse term, and with more than one light.

use crate::{Mistake, Parts, Section, Step, section};
use glam::DVec3;
use step04_diffuse::diffuse;
use step05_phong::{LIGHTS, Phong};

const AMBIENT: (&str, Section) =
    ("steps/step04_diffuse/src/ambient.rs", section::AMBIENT);
const LAMBERT: (&str, Section) =
    ("steps/step04_diffuse/src/diffuse.rs", section::LAMBERT);
const DIFFUSE: (&str, Section) =
    ("steps/step04_diffuse/src/diffuse.rs", section::DIFFUSE);
const SUM: (&str, Section) =
    ("steps/step04_diffuse/src/picture.rs", section::LIGHTS);

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        "no-max",
        "l·n may be below 0",
        "The side that faces away from a light is too dark, down to black.",
        "max(l·n, 0): a light behind the surface gives nothing, and takes nothing away.",
        LAMBERT,
        |parts| {
            parts.diffuse = |n, l, d, r_d, light| {
                r_d / light.attenuation.at(d) * l.dot(n) * light.diffuse
            };
        },
    ),
    wrong(
        "absolute",
        "|n·l| is taken for max(n·l, 0)",
        "The dark sides are lit as well, as if by lights behind them.",
        "A light behind the surface does not reach it.",
        LAMBERT,
        |parts| {
            parts.diffuse = |n, l, d, r_d, light| {
                r_d / light.attenuation.at(d) * l.dot(n).abs() * light.diffuse
            };
        },
    ),
    wrong(
        "no-cosine",
        "l·n is left out of the diffuse term",
        "Spheres are flat discs again, only brighter.",
        "By Lambert's law, light that comes in at a slant counts l·n times.",
        DIFFUSE,
        |parts| {
            parts.diffuse =
                |_, _, d, r_d, light| r_d / light.attenuation.at(d) * light.diffuse;
        },
    ),
    wrong(
        "no-colour",
        "R_d is left out of the diffuse term",
        "The lit sides are white: the colour of the light, not that of the sphere.",
        "The surface reflects only R_d of the light, in each of red, green and blue.",
        DIFFUSE,
        |parts| {
            parts.diffuse = |n, l, d, _, light| diffuse(n, l, d, DVec3::ONE, light);
        },
    ),
    wrong(
        "no-diffuse",
        "the diffuse term is left out",
        "Spheres are flat discs again, and dark.",
        "I is the sum of all its terms: each light adds its I_d.",
        SUM,
        |parts| parts.diffuse = |_, _, _, _, _| DVec3::ZERO,
    ),
    wrong(
        "no-ambient",
        "the ambient term is left out",
        "What no light reaches is black.",
        "The sum begins with I_a = R_a L_a.",
        AMBIENT,
        |parts| parts.ambient = |_, _| DVec3::ZERO,
    ),
    wrong(
        "ambient-without-colour",
        "R_a is left out of the ambient term",
        "Everything is pale, and the shadows are one bluish grey.",
        "The surface reflects only R_a of the ambient light, in its own colour.",
        AMBIENT,
        |parts| parts.ambient = |_, l_a| l_a,
    ),
    wrong(
        "ambient-per-light",
        "the ambient term is added for each light",
        "Everything is too bright, the shadows most of all.",
        "I_a belongs to no light: it stands before the loop, and counts once.",
        SUM,
        |parts| parts.ambient = |r_a, l_a| 2.0 * r_a * l_a,
    ),
    wrong(
        "first-light-only",
        "only the first light counts",
        "The right sides of the spheres have lost their bluish light.",
        "The sum runs over all lights.",
        SUM,
        |parts| parts.lights = &LIGHTS[..1],
    ),
    wrong(
        "last-light-only",
        "each light replaces the one before it",
        "Only the cool light is left, on the right sides.",
        "Add to the sum with `+=`: `=` forgets the light before.",
        SUM,
        |parts| parts.lights = &LIGHTS[1..],
    ),
    wrong(
        "averaged",
        "the light is divided by the number of lights",
        "Everything that is lit is too dark.",
        "Light adds up: two lamps are brighter than one.",
        SUM,
        |parts| {
            parts.sum = |&Phong { ambient, diffuse, specular }| {
                ambient + (diffuse + specular) / LIGHTS.len() as f64
            };
        },
    ),
];

const fn wrong(
    name: &'static str,
    when: &'static str,
    sees: &'static str,
    says: &'static str,
    (file, section): (&'static str, Section),
    change: fn(&mut Parts),
) -> Mistake {
    let step = Step::Diffuse;
    Mistake { name, step, file, section, when, sees, says, change }
}
