//! Mistakes with the specular term and the whole sum.

use crate::{Mistake, Parts, Section, Step, section};
use step05_phong::{Attenuation, Light, Material, PointLight, reflect, specular};

const REFLECT: (&str, Section) =
    ("steps/step05_phong/src/reflect.rs", section::REFLECT);
const SPECULAR: (&str, Section) =
    ("steps/step05_phong/src/specular.rs", section::SPECULAR);
const SUM: (&str, Section) = ("steps/step05_phong/src/phong.rs", section::SUM);
const EYE: (&str, Section) = ("steps/step05_phong/src/picture.rs", section::EYE);

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        "reflected-away",
        "r or v points the wrong way",
        "There are no highlights.",
        "r is 2(n·l)n − l, and v is −V: both lead away from the surface. The `reflect` of \
         GLSL has the other sign, as its l flies in.",
        REFLECT,
        |parts| parts.reflect = |l, n| -reflect(l, n),
    ),
    wrong(
        "reflected-by-half",
        "r has lost its 2: (n·l)n − l",
        "There are hardly any highlights.",
        "The mirror image is as far on the other side: 2(n·l)n − l.",
        REFLECT,
        |parts| parts.reflect = |l, n| n.dot(l) * n - l,
    ),
    wrong(
        "mirror-swapped",
        "n is mirrored in l",
        "The highlights are gone from the middle; faint ones are at the rims.",
        "`reflect(l, n)` takes l first: it is l that is mirrored, in n.",
        REFLECT,
        |parts| parts.reflect = |l, n| reflect(n, l),
    ),
    wrong(
        "eye-too-long",
        "v is −V and not a unit vector",
        "Highlights are too large, most of all far from the middle of the picture.",
        "The exponent makes much of a length above 1: divide −V by |V|.",
        EYE,
        |parts| parts.to_eye = |ray| -ray.direction,
    ),
    wrong(
        "no-exponent",
        "the exponent n is left out",
        "Highlights cover half of each sphere, like a second diffuse light.",
        "max(r·v, 0) is raised to the power of the shininess.",
        SPECULAR,
        |parts| {
            parts.specular = |r, v, d, material, light| {
                specular(r, v, d, &Material { shininess: 1, ..*material }, light)
            };
        },
    ),
    wrong(
        "times-exponent",
        "r·v is multiplied by n, not raised to it",
        "Half of each sphere is white.",
        "The exponent is a power: `powi`, not `*`.",
        SPECULAR,
        |parts| {
            parts.specular = |r, v, d, material, light| {
                let n = material.shininess;
                f64::from(n)
                    * specular(
                        r,
                        v,
                        d,
                        &Material { shininess: 1, ..*material },
                        light,
                    )
            };
        },
    ),
    wrong(
        "coloured-highlights",
        "highlights take R_d for R_s",
        "Highlights have the colours of their spheres.",
        "R_s is a number of its own; here it has no colour, as with varnish.",
        SPECULAR,
        |parts| {
            parts.specular = |r, v, d, material, light| {
                let painted =
                    Material { specular: material.surface.diffuse, ..*material };
                specular(r, v, d, &painted, light)
            };
        },
    ),
    wrong(
        "highlights-do-not-fade",
        "the specular term is not divided by a + bd + cd²",
        "The highlights of the cool light are too bright.",
        "Light fades before it is mirrored, as it does before it is scattered.",
        SPECULAR,
        |parts| {
            parts.specular = |r, v, d, material, light| {
                let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
                let point = PointLight { attenuation, ..light.point };
                specular(r, v, d, material, &Light { point, ..*light })
            };
        },
    ),
    wrong(
        "specular-no-max",
        "r·v may be below 0",
        "Spheres have a second highlight on the side away from the light.",
        "max(r·v, 0): a number below 0 to an even power is above 0 again.",
        SPECULAR,
        |parts| {
            parts.specular = |r, v, d, material, light| {
                let v = v * r.dot(v).signum();
                specular(r, v, d, material, light)
            };
        },
    ),
    wrong(
        "no-gate",
        "a light behind the surface gives highlights",
        "The teal sphere on the right has a wider, softer glint along its top.",
        "The slide has no such gate; we add light only where n·l is above 0.",
        SUM,
        |parts| parts.lit = |_, _| true,
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
    let step = Step::Phong;
    Mistake { name, step, file, section, when, sees, says, change }
}
