//! Mistakes with normals, the way to the light, and how light fades.

use crate::mistake::book;
use crate::{Mistake, Step, section};
use step04_diffuse::{Attenuation, PointLight, normal};

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "inward",
        when: "normals point into the spheres",
        sees: book("Spheres are lit on the side that faces away from the light."),
        says: "n is p − centre, from the centre to the surface.",
        change: |parts| parts.normal = |sphere, p| -normal(sphere, p),
        ..section::NORMAL.mistake()
    },
    Mistake {
        name: "normal-too-long",
        when: "n is not a unit vector",
        sees: book(
            "Large spheres are too bright, small ones too dark, and the ground is white.",
        ),
        says: "p − centre is as long as the radius: divide by it.",
        change: |parts| parts.normal = |sphere, p| p - sphere.centre,
        ..section::NORMAL.mistake()
    },
    Mistake {
        name: "normal-from-origin",
        when: "n is the direction of p, without the centre",
        sees: book("Spheres are flat: each has nearly one brightness."),
        says: "n is p − centre, and no sphere here is at the origin.",
        change: |parts| parts.normal = |_, p| p.normalize(),
        ..section::NORMAL.mistake()
    },
    Mistake {
        name: "light-away",
        step: Step::Phong,
        when: "l points from the light to the surface",
        sees: book("The side that faces away from each light is lit."),
        says: "l is position − p: from the surface to the light.",
        change: |parts| {
            parts.seen_from = |light, p| {
                let (l, d) = light.direction_from(p);
                (-l, d)
            };
        },
        ..section::LIGHT.mistake()
    },
    Mistake {
        name: "light-too-long",
        when: "l is not a unit vector",
        sees: book("Everything that is lit is far too bright."),
        says: "l·n is a cosine only where both are of length 1: divide l by d.",
        change: |parts| {
            parts.seen_from = |light, p| {
                let (l, d) = light.direction_from(p);
                (l * d, d)
            };
        },
        ..section::LIGHT.mistake()
    },
    Mistake {
        name: "light-from-origin",
        when: "l is the direction of the light's position, without p",
        sees: book(
            "Spheres are dark but for their upper left, and the light is the same on all.",
        ),
        says: "A point light is at one place: l is position − p.",
        change: |parts| {
            parts.seen_from = |light, p| {
                let (_, d) = light.direction_from(p);
                (light.position.normalize(), d)
            };
        },
        ..section::LIGHT.mistake()
    },
    Mistake {
        name: "distance-from-eye",
        when: "d is the distance to the eye",
        sees: book(
            "The ground in front of you is too bright, and its pool of bluish light is gone.",
        ),
        says: "d lies between the point and the light, in a + bd + cd².",
        change: |parts| {
            parts.seen_from = |light, p| {
                let (l, _) = PointLight::direction_from(light, p);
                (l, p.length())
            };
        },
        ..section::ATTENUATION.mistake()
    },
    Mistake {
        name: "no-attenuation",
        when: "light does not fade with distance",
        sees: book(
            "Nearly everything is too bright, and bluish light is on all right sides.",
        ),
        says: "The light is divided by a + bd + cd².",
        change: |parts| parts.attenuation = |_, _| 1.0,
        ..section::ATTENUATION.mistake()
    },
    Mistake {
        name: "multiplied",
        when: "the light is multiplied by a + bd + cd²",
        sees: book(
            "Everything that is lit is far too bright, the ground most of all.",
        ),
        says: "The light is divided by it: the farther, the darker.",
        change: |parts| parts.attenuation = |fades, d| 1.0 / fades.at(d),
        ..section::ATTENUATION.mistake()
    },
    Mistake {
        name: "d-not-squared",
        when: "c is multiplied by d, not by d²",
        sees: book(
            "The light is too strong, most of all the cool one on the right.",
        ),
        says: "The divisor is a + bd + cd².",
        change: |parts| {
            parts.attenuation = |fades, d| fades.a + fades.b * d + fades.c * d
        },
        ..section::ATTENUATION.mistake()
    },
    Mistake {
        name: "b-c-swapped",
        when: "b and c change places",
        sees: book("The warm light is too weak, and the cool one too strong."),
        says: "b belongs to d, and c to d².",
        change: |parts| {
            parts.attenuation =
                |&Attenuation { a, b, c }, d| Attenuation { a, b: c, c: b }.at(d);
        },
        ..section::ATTENUATION.mistake()
    },
];
