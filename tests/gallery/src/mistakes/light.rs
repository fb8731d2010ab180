//! Mistakes with normals, the way to the light, and how light fades.

use crate::{Mistake, Parts, Section, Step, section};
use step04_diffuse::{Attenuation, PointLight, normal};

const NORMAL: (&str, Section) =
    ("steps/step04_diffuse/src/normal.rs", section::NORMAL);
const LIGHT: (&str, Section) =
    ("steps/step04_diffuse/src/light.rs", section::LIGHT);
const FADES: (&str, Section) =
    ("steps/step04_diffuse/src/light.rs", section::ATTENUATION);

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        Step::Diffuse,
        "inward",
        "normals point into the spheres",
        "Spheres are lit on the side that faces away from the light.",
        "n is p − centre, from the centre to the surface.",
        NORMAL,
        |parts| parts.normal = |sphere, p| -normal(sphere, p),
    ),
    wrong(
        Step::Diffuse,
        "normal-too-long",
        "n is not a unit vector",
        "Large spheres are too bright, small ones too dark, and the ground is white.",
        "p − centre is as long as the radius: divide by it.",
        NORMAL,
        |parts| parts.normal = |sphere, p| p - sphere.centre,
    ),
    wrong(
        Step::Diffuse,
        "normal-from-origin",
        "n is the direction of p, without the centre",
        "Spheres are flat: each has nearly one brightness.",
        "n is p − centre, and no sphere here is at the origin.",
        NORMAL,
        |parts| parts.normal = |_, p| p.normalize(),
    ),
    wrong(
        Step::Phong,
        "light-away",
        "l points from the light to the surface",
        "The side that faces away from each light is lit.",
        "l is position − p: from the surface to the light.",
        LIGHT,
        |parts| {
            parts.seen_from = |light, p| {
                let (l, d) = light.seen_from(p);
                (-l, d)
            };
        },
    ),
    wrong(
        Step::Diffuse,
        "light-too-long",
        "l is not a unit vector",
        "Everything that is lit is far too bright.",
        "l·n is a cosine only where both are of length 1: divide l by d.",
        LIGHT,
        |parts| {
            parts.seen_from = |light, p| {
                let (l, d) = light.seen_from(p);
                (l * d, d)
            };
        },
    ),
    wrong(
        Step::Diffuse,
        "light-from-origin",
        "l is the direction of the light's position, without p",
        "Spheres are dark but for their upper left, and the light is the same on all.",
        "A point light is at one place: l is position − p.",
        LIGHT,
        |parts| {
            parts.seen_from = |light, p| {
                let (_, d) = light.seen_from(p);
                (light.position.normalize(), d)
            };
        },
    ),
    wrong(
        Step::Diffuse,
        "distance-from-eye",
        "d is the distance to the eye",
        "The ground before you is too bright, and its pool of bluish light is gone.",
        "d lies between the point and the light, in a + bd + cd².",
        FADES,
        |parts| {
            parts.seen_from = |light, p| {
                let (l, _) = PointLight::seen_from(light, p);
                (l, p.length())
            };
        },
    ),
    wrong(
        Step::Diffuse,
        "no-attenuation",
        "light does not fade with distance",
        "Everything is too bright, and bluish light is on all right sides.",
        "The light is divided by a + bd + cd².",
        FADES,
        |parts| parts.attenuation = |_, _| 1.0,
    ),
    wrong(
        Step::Diffuse,
        "multiplied",
        "the light is multiplied by a + bd + cd²",
        "Everything that is lit is far too bright, the ground most of all.",
        "The light is divided by it: the farther, the darker.",
        FADES,
        |parts| parts.attenuation = |fades, d| 1.0 / fades.at(d),
    ),
    wrong(
        Step::Diffuse,
        "d-not-squared",
        "c is multiplied by d, not by d²",
        "The light is too strong, most of all the cool one on the right.",
        "The divisor is a + bd + cd².",
        FADES,
        |parts| parts.attenuation = |fades, d| fades.a + fades.b * d + fades.c * d,
    ),
    wrong(
        Step::Diffuse,
        "b-c-swapped",
        "b and c change places",
        "The warm light is too weak, and the cool one too strong.",
        "b belongs to d, and c to d².",
        FADES,
        |parts| {
            parts.attenuation =
                |&Attenuation { a, b, c }, d| Attenuation { a, b: c, c: b }.at(d);
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
