//! Mistakes with the specular term and the whole sum.

use crate::mistake::book;
use crate::{Mistake, section};
use step05_phong::{Attenuation, Light, PointLight, reflect, specular};

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "reflected-away",
        when: "r or v points the wrong way",
        sees: book("There are no highlights."),
        says: "r is 2(n·l)n − l, and v is −V: both lead away from the surface. The `reflect` of \
         GLSL has the other sign, as its l flies in.",
        change: |parts| parts.reflect = |l, n| -reflect(n, l),
        ..section::REFLECT.mistake()
    },
    Mistake {
        name: "reflected-by-half",
        when: "r has lost its 2: (n·l)n − l",
        sees: book("There are hardly any highlights."),
        says: "The mirror image is as far on the other side: 2(n·l)n − l.",
        change: |parts| parts.reflect = |l, n| n.dot(l) * n - l,
        ..section::REFLECT.mistake()
    },
    Mistake {
        name: "mirror-swapped",
        when: "n is mirrored in l",
        sees: book(
            "The highlights are gone from the middle; faint ones are at the rims.",
        ),
        says: "`reflect(n, l)` takes l first: it is l that is mirrored, in n.",
        change: |parts| parts.reflect = |l, n| reflect(l, n),
        ..section::REFLECT.mistake()
    },
    Mistake {
        name: "eye-too-long",
        when: "v is −V and not a unit vector",
        sees: book(
            "Highlights are too large, most of all far from the middle of the picture.",
        ),
        says: "The exponent makes much of a length above 1: divide −V by |V|.",
        change: |parts| parts.to_eye = |ray| -ray.direction,
        ..section::EYE.mistake()
    },
    Mistake {
        name: "no-exponent",
        when: "the exponent n is left out",
        sees: book(
            "Highlights cover half of each sphere, like a second diffuse light.",
        ),
        says: "max(r·v, 0) is raised to the power of the shininess.",
        change: |parts| parts.materials().for_each(|m| m.shininess = 1),
        ..section::SPECULAR.mistake()
    },
    Mistake {
        name: "times-exponent",
        when: "r·v is multiplied by n, not raised to it",
        sees: book("Half of each sphere is white."),
        says: "The exponent is a power: `powi`, not `*`.",
        change: |parts| {
            parts.materials().for_each(|m| {
                m.specular *= f64::from(m.shininess);
                m.shininess = 1;
            });
        },
        ..section::SPECULAR.mistake()
    },
    Mistake {
        name: "coloured-highlights",
        when: "highlights take R_d for R_s",
        sees: book("Highlights have the colours of their spheres."),
        says: "R_s is a number of its own; here it has no colour, as with varnish.",
        change: |parts| {
            parts.materials().for_each(|m| m.specular = m.surface.diffuse);
        },
        ..section::SPECULAR.mistake()
    },
    Mistake {
        name: "highlights-do-not-fade",
        when: "the specular term is not divided by a + bd + cd²",
        sees: book(
            "Most highlights are too bright; the cool one on the salmon sphere is too dark.",
        ),
        says: "Light fades before it is mirrored, as it does before it is scattered.",
        change: |parts| {
            parts.specular = |r, v, d, material, light| {
                let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
                let point_light = PointLight { attenuation, ..light.point_light };
                specular(r, v, d, material, &Light { point_light, ..*light })
            };
        },
        ..section::SPECULAR.mistake()
    },
    Mistake {
        name: "specular-no-max",
        when: "r·v may be below 0",
        sees: book("It looks right, but the ground is brighter by a few of 255."),
        says: "max(r·v, 0): a number below 0 to an even power is above 0 again.",
        change: |parts| {
            parts.specular = |r, v, d, material, light| {
                let v = v * r.dot(v).signum();
                specular(r, v, d, material, light)
            };
        },
        ..section::SPECULAR.mistake()
    },
    Mistake {
        name: "no-gate",
        when: "lights behind the surface give highlights",
        sees: book(
            "The teal sphere on the right has a wider, softer glint along its top.",
        ),
        says: "The slide has no such gate; we add light only where n·l is above 0.",
        change: |parts| parts.lit = |_, _| true,
        ..section::SUM.mistake()
    },
];
