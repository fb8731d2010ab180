//! Mistakes with the quadratic of a sphere.

use crate::mistake::book;
use crate::{Mistake, Step, section};
use glam::DVec3;
use step02_sphere::{Roots, Sphere, quadratic};

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "never-hits",
        when: "no ray meets any sphere, as b has lost its 2",
        sees: book("There are no spheres: only the sky is left."),
        says: "b is 2 S·V with S taken from the centre; in step 2, a wrong sign of b gives the same picture.",
        change: |parts| parts.quadratic = |a, b, c| quadratic(a, b / 2.0, c),
        ..section::MEETING.mistake()
    },
    Mistake {
        name: "always-hits",
        when: "D is never below 0, as it has a plus: b² + 4ac",
        sees: book("There is no sky: every ray meets a sphere."),
        says: "D is b² − 4ac; it is below 0 where a ray misses.",
        change: |parts| parts.quadratic = |a, b, c| quadratic(a, b, -c),
        ..section::FORMULA.mistake()
    },
    Mistake {
        name: "a-left-out",
        step: Step::Nearest,
        when: "a is taken for 1",
        sees: book("There is no sky, and the spheres have straight borders."),
        says: "a is V·V, and V has the length 1 in the middle of the picture only.",
        change: |parts| parts.quadratic = |_, b, c| quadratic(1.0, b, c),
        ..section::MEETING.mistake()
    },
    Mistake {
        name: "a-is-a-length",
        when: "a is the length of V, not its square",
        sees: book("The spheres are too large."),
        says: "a is V·V, the square of the length; there is no root in it.",
        change: |parts| parts.quadratic = |a, b, c| quadratic(a.sqrt(), b, c),
        ..section::MEETING.mistake()
    },
    Mistake {
        name: "four-left-out",
        step: Step::Nearest,
        when: "D has lost its 4: b² − ac",
        sees: book(
            "The spheres are so large that one or two of them fill the picture.",
        ),
        says: "D is b² − 4ac, with b = 2 S·V; who leaves out the 4 leaves out that 2 as well.",
        change: |parts| parts.quadratic = |a, b, c| quadratic(a, b, c / 4.0),
        ..section::FORMULA.mistake()
    },
    Mistake {
        name: "c-is-a-length",
        step: Step::Nearest,
        when: "c has the length of S, not its square",
        sees: book(
            "The spheres are so large that two or three of them fill the picture.",
        ),
        says: "c is S·S − r², and S·S is the square of a length.",
        change: |parts| {
            parts.coefficients = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                let s = (ray.start - sphere.centre).length();
                (a, b, c - s * s + s)
            };
        },
        ..section::MEETING.mistake()
    },
    Mistake {
        name: "wrong-side",
        step: Step::Nearest,
        when: "the centre has the wrong sign",
        sees: book(
            "What is ahead is missing, and the green sphere from behind the camera is seen.",
        ),
        says: "S is taken from the centre, start − centre; with a plus, or with b for −b, \
         every sphere is mirrored in the eye.",
        change: |parts| {
            parts.coefficients = |sphere, ray| {
                Sphere { centre: -sphere.centre, ..*sphere }.coefficients(ray)
            };
        },
        ..section::CENTRE.mistake()
    },
    Mistake {
        name: "centre-ignored",
        step: Step::Nearest,
        when: "every sphere is at the origin",
        sees: book(
            "One colour fills the picture: you stand inside all the spheres.",
        ),
        says: "The lecture's sphere is at the origin; take S from the centre, start − centre.",
        change: |parts| {
            parts.coefficients = |sphere, ray| {
                Sphere { centre: DVec3::ZERO, ..*sphere }.coefficients(ray)
            };
        },
        ..section::CENTRE.mistake()
    },
    Mistake {
        name: "radius-not-squared",
        step: Step::Nearest,
        when: "c has r where r² should be",
        sees: book(
            "Small spheres are too large, large ones too small, and the ground is gone.",
        ),
        says: "c is S·S − r²; a sphere of radius 1, as in step 2, does not show it.",
        change: |parts| {
            parts.coefficients = |sphere, ray| {
                let radius = sphere.radius.sqrt();
                Sphere { radius, ..*sphere }.coefficients(ray)
            };
        },
        ..section::MEETING.mistake()
    },
    Mistake {
        name: "far-root",
        step: Step::Diffuse,
        when: "the far root is taken",
        sees: book(
            "Outlines are right, but every sphere has the light of its far side.",
        ),
        says: "The ray goes in at the near root, −b − √D, and comes out at the far one.",
        change: |parts| {
            parts.first_hit = |roots| match roots {
                Roots::Two(_, far) => Some(far).filter(|&t| 0.0 < t),
                roots => roots.first_hit(),
            };
        },
        ..section::ROOT.mistake()
    },
    Mistake {
        name: "behind",
        step: Step::Nearest,
        when: "hits behind the eye count",
        sees: book("The green sphere is seen, though it is behind the camera."),
        says: "Only a t above 0 is ahead.",
        change: |parts| {
            parts.first_hit = |roots| match roots {
                Roots::None => None,
                Roots::One(t) | Roots::Two(t, _) => Some(t),
            };
        },
        ..section::ROOT.mistake()
    },
    Mistake {
        name: "root-left-out",
        step: Step::Nearest,
        when: "D stands where its root should",
        sees: book(
            "It looks right, but some borders where spheres overlap are not.",
        ),
        says: "t is (−b − √D) / 2a; the outline depends on the sign of D alone.",
        change: |parts| {
            parts.quadratic = |a, b, c| {
                let d = b * b - 4.0 * a * c;
                // The same middle, −b/2a, and the wrong distance from it.
                match d < 0.0 {
                    true => Roots::None,
                    false => quadratic(a, b, (b * b - d * d) / (4.0 * a)),
                }
            };
        },
        ..section::FORMULA.mistake()
    },
    Mistake {
        name: "divided-by-a",
        step: Step::Diffuse,
        when: "the divisor is a, not 2a",
        sees: book("Outlines are right, but nearly everything is dark."),
        says: "t is (−b − √D) / 2a; one t that is twice too large changes no outline.",
        change: |parts| parts.first_hit = |roots| Some(2.0 * roots.first_hit()?),
        ..section::FORMULA.mistake()
    },
    Mistake {
        name: "half-times-a",
        step: Step::Diffuse,
        when: "the division by 2a is written `/ 2.0 * a`",
        sees: book(
            "Outlines are right, and the light goes wrong away from the middle.",
        ),
        says: "That divides by 2 and multiplies by a: put `2.0 * a` into parentheses.",
        change: |parts| {
            // Each root of this one is a² times what it was.
            parts.quadratic = |a, b, c| quadratic(a, b * a * a, c * a.powi(4));
        },
        ..section::FORMULA.mistake()
    },
];
