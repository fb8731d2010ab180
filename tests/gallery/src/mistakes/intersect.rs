//! Mistakes with the quadratic of a sphere.

use crate::{Mistake, Parts, Section, Step, section};
use glam::DVec3;
use step02_sphere::{Ray, Roots, Sphere, quadratic};

const SPHERE: (&str, Section) =
    ("steps/step02_sphere/src/sphere.rs", section::MEETING);
const CENTRE: (&str, Section) =
    ("steps/step02_sphere/src/sphere.rs", section::CENTRE);
const FORMULA: (&str, Section) =
    ("steps/step02_sphere/src/quadratic.rs", section::FORMULA);
const ROOT: (&str, Section) =
    ("steps/step02_sphere/src/quadratic.rs", section::ROOT);

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        Step::Sphere,
        "never-hits",
        "no ray meets any sphere, as b has lost its 2 or a sign in it is wrong",
        "There are no spheres: only the sky is left.",
        "b is 2 S·V with S taken from the centre, and the near root begins with −b.",
        SPHERE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                quadratic(a, b / 2.0, c).first_hit()
            };
        },
    ),
    wrong(
        Step::Sphere,
        "always-hits",
        "D is never below 0, as it has a plus: b² + 4ac",
        "There is no sky: every ray meets a sphere.",
        "D is b² − 4ac; it is below 0 where a ray misses.",
        FORMULA,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                quadratic(a, b, -c).first_hit()
            };
        },
    ),
    wrong(
        Step::Nearest,
        "a-left-out",
        "a is taken for 1",
        "There is no sky, and the spheres have straight borders.",
        "a is V·V, and V has the length 1 in the middle of the picture only.",
        SPHERE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (_, b, c) = sphere.coefficients(ray);
                quadratic(1.0, b, c).first_hit()
            };
        },
    ),
    wrong(
        Step::Sphere,
        "a-is-a-length",
        "a is the length of V, not its square",
        "The spheres are too large.",
        "a is V·V, the square of the length; there is no root in it.",
        SPHERE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                quadratic(a.sqrt(), b, c).first_hit()
            };
        },
    ),
    wrong(
        Step::Nearest,
        "four-left-out",
        "D has lost its 4: b² − ac",
        "The spheres are so large that one or two of them fill the picture.",
        "D is b² − 4ac, with b = 2 S·V; who leaves out the 4 leaves out that 2 as well.",
        FORMULA,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                quadratic(a, b, c / 4.0).first_hit()
            };
        },
    ),
    wrong(
        Step::Nearest,
        "c-is-a-length",
        "c has the length of S, not its square",
        "The spheres are so large that two or three of them fill the picture.",
        "c is S·S − r², and S·S is the square of a length.",
        SPHERE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                let s = (ray.start - sphere.centre).length();
                quadratic(a, b, c - s * s + s).first_hit()
            };
        },
    ),
    wrong(
        Step::Nearest,
        "wrong-side",
        "the centre has the wrong sign",
        "What is ahead is missing, and the green sphere from behind the camera is seen.",
        "S is taken from the centre, start − centre; with a plus, or with b for −b, \
         every sphere is mirrored in the eye.",
        CENTRE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                Sphere { centre: -sphere.centre, ..*sphere }
                    .intersect(ray)
                    .first_hit()
            };
        },
    ),
    wrong(
        Step::Nearest,
        "centre-ignored",
        "every sphere is at the origin",
        "One colour fills the picture: you stand inside all the spheres.",
        "The lecture's sphere is at the origin; take S from the centre, start − centre.",
        CENTRE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                Sphere { centre: DVec3::ZERO, ..*sphere }.intersect(ray).first_hit()
            };
        },
    ),
    wrong(
        Step::Nearest,
        "radius-not-squared",
        "c has r where r² should be",
        "Small spheres are too large, large ones too small, and the ground is gone.",
        "c is S·S − r²; a sphere of radius 1, as in step 2, does not show it.",
        SPHERE,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let radius = sphere.radius.sqrt();
                Sphere { radius, ..*sphere }.intersect(ray).first_hit()
            };
        },
    ),
    wrong(
        Step::Diffuse,
        "far-root",
        "the far root is taken",
        "Outlines are right, but every sphere has the light of its far side.",
        "The ray goes in at the near root, −b − √D, and comes out at the far one.",
        ROOT,
        |parts| {
            parts.first_hit = |sphere, ray| match sphere.intersect(ray) {
                Roots::Two(_, far) => Some(far).filter(|&t| 0.0 < t),
                roots => roots.first_hit(),
            };
        },
    ),
    wrong(
        Step::Nearest,
        "behind",
        "hits behind the eye count",
        "The green sphere is seen, though it is behind the camera.",
        "Only a t above 0 is ahead.",
        ROOT,
        |parts| {
            parts.first_hit = |sphere, ray| match sphere.intersect(ray) {
                Roots::None => None,
                Roots::One(t) | Roots::Two(t, _) => Some(t),
            };
        },
    ),
    wrong(
        Step::Nearest,
        "root-left-out",
        "D stands where its root should",
        "It looks right, but some borders where spheres overlap are not.",
        "t is (−b − √D) / 2a; the outline depends on the sign of D alone.",
        FORMULA,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, b, c) = sphere.coefficients(ray);
                let d = b * b - 4.0 * a * c;
                // The same middle, −b/2a, and the wrong distance from it.
                let roots = quadratic(a, b, (b * b - d * d) / (4.0 * a));
                roots.first_hit().filter(|_| 0.0 <= d)
            };
        },
    ),
    wrong(
        Step::Diffuse,
        "divided-by-a",
        "the divisor is a, not 2a",
        "Outlines are right, but nearly everything is dark.",
        "t is (−b − √D) / 2a; one t that is twice too large changes no outline.",
        FORMULA,
        |parts| parts.first_hit = |sphere, ray| Some(2.0 * first(sphere, ray)?),
    ),
    wrong(
        Step::Diffuse,
        "half-times-a",
        "the division by 2a is written `/ 2.0 * a`",
        "Outlines are right, and the light goes wrong away from the middle.",
        "That divides by 2 and multiplies by a: put `2.0 * a` into parentheses.",
        FORMULA,
        |parts| {
            parts.first_hit = |sphere, ray| {
                let (a, ..) = sphere.coefficients(ray);
                Some(first(sphere, ray)? * a * a)
            };
        },
    ),
];

/// The right first hit.
fn first(sphere: &Sphere, ray: &Ray) -> Option<f64> {
    sphere.intersect(ray).first_hit()
}

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
