use super::{Alternative, part};
use crate::Parts;
use crate::section::{CENTRE, FORMULA, MEETING, NEAREST, ROOT, SCENE};
use step02_sphere::{Roots, quadratic};
use step03_nearest::Hit;

/// The two roots with another discriminant.
fn roots(a: f64, b: f64, d: f64) -> Roots {
    match d < 0.0 {
        true => Roots::None,
        false => {
            Roots::Two((-b - d.sqrt()) / (2.0 * a), (-b + d.sqrt()) / (2.0 * a))
        }
    }
}

/// The first hit with another near root, made of a, b and √D.
fn near(near: f64, far: f64) -> Roots {
    Roots::Two(near, far)
}

/// Changes every radius of the scene.
fn scaled(parts: &mut Parts, radius: fn(f64) -> f64) {
    for object in &mut parts.scene.objects {
        object.sphere.radius = radius(object.sphere.radius);
    }
}

/// Keeps only some of the spheres.
fn keep(parts: &mut Parts, is_kept: fn(usize) -> bool) {
    for (k, object) in parts.scene.objects.iter_mut().enumerate() {
        if !is_kept(k) {
            object.sphere.centre.z = 1e9;
            object.sphere.radius = 1e-9;
        }
    }
}

pub(super) const ALL: &[Alternative] = &[
    part(FORMULA, "D has 2 for 4: b² − 2ac", |p| {
        p.quadratic = |a, b, c| roots(a, b, b * b - 2.0 * a * c)
    }),
    part(
        FORMULA,
        "D has lost its 4, but the roots divide by 2a: b² − ac",
        |p| p.quadratic = |a, b, c| roots(a, b, b * b - a * c),
    ),
    part(FORMULA, "D has b for b²", |p| {
        p.quadratic = |a, b, c| roots(a, b, b - 4.0 * a * c)
    }),
    part(FORMULA, "D has lost its a: b² − 4c", |p| {
        p.quadratic = |a, b, c| roots(a, b, b * b - 4.0 * c)
    }),
    part(FORMULA, "D has lost its c: b² − 4a", |p| {
        p.quadratic = |a, b, _| roots(a, b, b * b - 4.0 * a)
    }),
    part(FORMULA, "D is (b² − 4a) c", |p| {
        p.quadratic = |a, b, c| roots(a, b, (b * b - 4.0 * a) * c)
    }),
    part(FORMULA, "D has b for a: b² − 4bc", |p| {
        p.quadratic = |a, b, c| roots(a, b, b * b - 4.0 * b * c)
    }),
    part(FORMULA, "D has its sign turned: 4ac − b²", |p| {
        p.quadratic = |a, b, c| roots(a, b, 4.0 * a * c - b * b)
    }),
    part(FORMULA, "D has 8 for 4", |p| {
        p.quadratic = |a, b, c| roots(a, b, b * b - 8.0 * a * c)
    }),
    part(FORMULA, "the case D < 0 is turned round", |p| {
        p.quadratic = |a, b, c| match 0.0 < b * b - 4.0 * a * c {
            true => Roots::None,
            false => quadratic(a, b, c),
        };
    }),
    part(FORMULA, "the near root is divided by 2, not 2a", |p| {
        p.quadratic = |a, b, c| match quadratic(a, b, c) {
            Roots::Two(t, far) => near(t * a, far),
            other => other,
        };
    }),
    part(FORMULA, "the near root is divided by 2 and multiplied by a", |p| {
        p.quadratic = |a, b, c| match quadratic(a, b, c) {
            Roots::Two(t, far) => near(t * a * a, far),
            other => other,
        };
    }),
    part(FORMULA, "the near root is divided by a, not 2a", |p| {
        p.quadratic = |a, b, c| match quadratic(a, b, c) {
            Roots::Two(t, far) => near(2.0 * t, far),
            other => other,
        };
    }),
    part(
        FORMULA,
        "the near root has b for −b, so that only the far root is left",
        |p| {
            p.quadratic = |a, b, c| match quadratic(a, b, c) {
                Roots::Two(t, far) => near(t + b / a, far),
                other => other,
            };
        },
    ),
    part(FORMULA, "both roots have b for −b", |p| {
        p.quadratic = |a, b, c| quadratic(a, -b, c)
    }),
    part(
        FORMULA,
        "the near root has lost its parentheses: −b − √D / 2a",
        |p| {
            p.quadratic = |a, b, c| match quadratic(a, b, c) {
                Roots::Two(_, far) => {
                    near(-b - (b * b - 4.0 * a * c).sqrt() / (2.0 * a), far)
                }
                other => other,
            };
        },
    ),
    part(FORMULA, "the near root has D for √D", |p| {
        p.quadratic = |a, b, c| match quadratic(a, b, c) {
            Roots::Two(_, far) => {
                near((-b - (b * b - 4.0 * a * c)) / (2.0 * a), far)
            }
            other => other,
        };
    }),
    part(FORMULA, "the near root has lost its √D: −b / 2a", |p| {
        p.quadratic = |a, b, c| match quadratic(a, b, c) {
            Roots::Two(_, far) => near(-b / (2.0 * a), far),
            other => other,
        };
    }),
    part(ROOT, "the far root comes first, or both are the far one", |p| {
        p.first_hit = |roots| match roots {
            Roots::Two(near, far) => {
                let first = Some(far).filter(|t| 0.0 < *t);
                first.or(Some(near).filter(|t| 0.0 < *t))
            }
            roots => roots.first_hit(),
        };
    }),
    part(ROOT, "only roots below 0 count: t < 0 for 0 < t", |p| {
        p.first_hit = |roots| match roots {
            Roots::One(t) | Roots::Two(t, _) if t < 0.0 => Some(t),
            Roots::Two(_, t) if t < 0.0 => Some(t),
            _ => None,
        };
    }),
    part(ROOT, "a far root below 0 counts", |p| {
        p.first_hit = |roots| match roots {
            Roots::One(t) | Roots::Two(t, _) if 0.0 < t => Some(t),
            Roots::Two(_, t) if t < 0.0 => Some(t),
            _ => None,
        };
    }),
    part(CENTRE, "S is turned round, centre − start", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            (a, -b, c)
        };
    }),
    part(MEETING, "V is normalised in the coefficients", |p| {
        p.coefficients = |sphere, ray| {
            let direction = ray.direction.normalize();
            sphere.coefficients(&step01_rays::Ray { direction, ..*ray })
        };
    }),
    part(MEETING, "a is S·S", |p| {
        p.coefficients = |sphere, ray| {
            let (_, b, c) = sphere.coefficients(ray);
            (c + sphere.radius * sphere.radius, b, c)
        };
    }),
    part(MEETING, "a has a 2: 2 V·V", |p| {
        p.quadratic = |a, b, c| quadratic(2.0 * a, b, c)
    }),
    part(MEETING, "b is 2 S·S", |p| {
        p.coefficients = |sphere, ray| {
            let (a, _, c) = sphere.coefficients(ray);
            (a, 2.0 * (c + sphere.radius * sphere.radius), c)
        };
    }),
    part(MEETING, "b is 2 V·V", |p| {
        p.quadratic = |a, _, c| quadratic(a, 2.0 * a, c)
    }),
    part(MEETING, "b is 2 + S·V", |p| {
        p.quadratic = |a, b, c| quadratic(a, 2.0 + b / 2.0, c)
    }),
    part(MEETING, "c has a plus: S·S + r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            (a, b, c + 2.0 * sphere.radius * sphere.radius)
        };
    }),
    part(MEETING, "c has 2r for r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            (a, b, c + sphere.radius * sphere.radius - 2.0 * sphere.radius)
        };
    }),
    part(MEETING, "c has lost its r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            (a, b, c + sphere.radius * sphere.radius)
        };
    }),
    part(MEETING, "c has lost its S·S: it is r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, _) = sphere.coefficients(ray);
            (a, b, sphere.radius * sphere.radius)
        };
    }),
    part(MEETING, "c has lost its S·S: it is −r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, _) = sphere.coefficients(ray);
            (a, b, -sphere.radius * sphere.radius)
        };
    }),
    part(MEETING, "c has r³ for r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            let r = sphere.radius;
            (a, b, c + r * r - r * r * r)
        };
    }),
    part(MEETING, "c has r⁴ for r²", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            let r = sphere.radius;
            (a, b, c + r * r - r.powi(4))
        };
    }),
    part(MEETING, "all radii are doubled", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            (a, b, c - 3.0 * sphere.radius.powi(2))
        };
    }),
    part(MEETING, "all radii are halved", |p| {
        p.coefficients = |sphere, ray| {
            let (a, b, c) = sphere.coefficients(ray);
            (a, b, c + 0.75 * sphere.radius.powi(2))
        };
    }),
    part(SCENE, "all radii are doubled in the scene, 2 r", |p| {
        scaled(p, |r| 2.0 * r)
    }),
    part(SCENE, "all radii are halved in the scene, r / 2", |p| {
        scaled(p, |r| r / 2.0)
    }),
    part(SCENE, "all radii are squared in the scene, r²", |p| {
        scaled(p, |r| r * r)
    }),
    part(MEETING, "a and c change places", |p| {
        p.quadratic = |a, b, c| quadratic(c, b, a)
    }),
    part(MEETING, "b and c change places", |p| {
        p.quadratic = |a, b, c| quadratic(a, c, b)
    }),
    part(MEETING, "a and b change places", |p| {
        p.quadratic = |a, b, c| quadratic(b, a, c)
    }),
    part(
        NEAREST,
        "the first object of the list, the red sphere, is left out",
        |p| keep(p, |k| k != 0),
    ),
    part(
        NEAREST,
        "the last object of the list, the cream sphere, is left out",
        |p| keep(p, |k| k != 8),
    ),
    part(NEAREST, "only the first five objects are asked", |p| keep(p, |k| k < 5)),
    part(NEAREST, "no hit is ever kept", |p| p.nearest = |_| None),
    part(NEAREST, "every hit has the t of 1", |p| {
        p.nearest = |hits| {
            let first = hits.next();
            hits.for_each(drop);
            first.map(|hit| Hit { t: 1.0, ..hit })
        };
    }),
    part(NEAREST, "every hit has the t of 1, and the last one is kept", |p| {
        p.nearest = |hits| hits.last().map(|hit| Hit { t: 1.0, ..hit });
    }),
];
