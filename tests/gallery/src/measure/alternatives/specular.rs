use super::{Alternative, part, vectors};
use crate::section::{EYE, REFLECT, SPECULAR, SUM};
use glam::DVec3;
use step05_phong::{Light, Material};

/// The specular term with another power of the cosine.
fn term(power: f64, d: f64, material: &Material, light: &Light) -> DVec3 {
    material.specular / light.point.attenuation.at(d) * power * light.specular
}

/// n as a number.
fn n(material: &Material) -> f64 {
    f64::from(material.shininess)
}

/// The same where r·v is above 0, and nothing elsewhere.
fn power(r: DVec3, v: DVec3, power: impl Fn(f64) -> f64) -> f64 {
    let cosine = r.dot(v);
    if cosine <= 0.0 { 0.0 } else { power(cosine) }
}

pub(super) const ALL: &[Alternative] = &[
    vectors(EYE, "v is V/|V|, without its minus: no highlight is left", 2, |v| {
        v.v = -v.v
    }),
    vectors(EYE, "v is n", 2, |v| v.v = v.n),
    vectors(EYE, "v is (0, 0, 1) everywhere", 2, |v| v.v = DVec3::Z),
    vectors(EYE, "v is the direction of p", 2, |v| v.v = v.p.normalize()),
    vectors(EYE, "v is l", 2, |v| v.v = v.l),
    vectors(REFLECT, "l stands for r: it is not mirrored", 2, |v| v.r = v.l),
    vectors(REFLECT, "n stands for r", 2, |v| v.r = v.n),
    vectors(REFLECT, "v is mirrored in n, and compared with itself", 2, |v| {
        v.r = 2.0 * v.n.dot(v.v) * v.n - v.v
    }),
    vectors(REFLECT, "v is mirrored in n, not l", 2, |v| {
        (v.r, v.v) = (2.0 * v.n.dot(v.v) * v.n - v.v, v.l);
    }),
    vectors(
        SPECULAR,
        "the halfway vector's cosine with n is taken for r·v",
        2,
        |v| {
            (v.r, v.v) = ((v.l + v.v).normalize(), v.n);
        },
    ),
    vectors(SPECULAR, "the halfway vector of r and v is taken for r", 2, |v| {
        v.r = (v.r + v.v).normalize()
    }),
    vectors(SPECULAR, "r·r is taken for r·v", 2, |v| v.v = v.r),
    vectors(SPECULAR, "the specular term has a d of 1", 2, |v| v.d = 1.0),
    vectors(SPECULAR, "the specular term has d² for d", 2, |v| v.d *= v.d),
    vectors(SPECULAR, "the specular term has 1/d for d", 2, |v| v.d = 1.0 / v.d),
    part(REFLECT, "r has a plus: 2(n·l)n + l", |p| {
        p.reflect = |l, n| 2.0 * n.dot(l) * n + l
    }),
    part(REFLECT, "r has lost its n·l: 2n − l", |p| {
        p.reflect = |l, n| 2.0 * n - l
    }),
    part(REFLECT, "r has lost its last n: 2(n·l) − l", |p| {
        p.reflect = |l, n| 2.0 * n.dot(l) - l
    }),
    part(REFLECT, "r has 4 for 2", |p| p.reflect = |l, n| 4.0 * n.dot(l) * n - l),
    part(REFLECT, "r has 3 for 2", |p| p.reflect = |l, n| 3.0 * n.dot(l) * n - l),
    part(REFLECT, "r has n for its last l: 2(n·l)n − n", |p| {
        p.reflect = |l, n| 2.0 * n.dot(l) * n - n
    }),
    part(REFLECT, "r has lost its − l: 2(n·l)n", |p| {
        p.reflect = |l, n| 2.0 * n.dot(l) * n
    }),
    part(SUM, "the gate is turned round: n·l below 0", |p| {
        p.lit = |n, l| n.dot(l) < 0.0
    }),
    part(SUM, "the gate is n·l above ½", |p| p.lit = |n, l| 0.5 < n.dot(l)),
    part(SPECULAR, "the exponent is n/2", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(m.shininess / 2)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 2n", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(m.shininess * 2)), d, m, l)
    }),
    part(SPECULAR, "the exponent is n²", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powf(n(m).powi(2))), d, m, l)
    }),
    part(SPECULAR, "the exponent is n/10", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(m.shininess / 10)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 10 n", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(m.shininess * 10)), d, m, l)
    }),
    part(SPECULAR, "the exponent is n + 1", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(m.shininess + 1)), d, m, l)
    }),
    part(SPECULAR, "the exponent is n − 1", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(m.shininess - 1)), d, m, l)
    }),
    part(SPECULAR, "the exponent is −n", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powi(-m.shininess)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 1/n", |p| {
        p.specular =
            |r, v, d, m, l| term(power(r, v, |c| c.powf(1.0 / n(m))), d, m, l)
    }),
    part(SPECULAR, "the exponent is 2 everywhere", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |c| c.powi(2)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 5 everywhere", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |c| c.powi(5)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 10 everywhere", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |c| c.powi(10)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 32 everywhere", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |c| c.powi(32)), d, m, l)
    }),
    part(SPECULAR, "the exponent is 100 everywhere", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |c| c.powi(100)), d, m, l)
    }),
    part(SPECULAR, "n is raised to r·v, not r·v to n", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |c| n(m).powf(c)), d, m, l)
    }),
    part(SPECULAR, "1 − (r·v)ⁿ is taken for (r·v)ⁿ", |p| {
        p.specular = |r, v, d, m, l| {
            term(power(r, v, |c| 1.0 - c.powi(m.shininess)), d, m, l)
        }
    }),
    part(SPECULAR, "(r·v)ⁿ is left out", |p| {
        p.specular = |r, v, d, m, l| term(power(r, v, |_| 1.0), d, m, l)
    }),
    part(SPECULAR, "only r·v below 0 counts", |p| {
        p.specular = |r, v, d, m, l| match 0.0 < r.dot(v) {
            true => DVec3::ZERO,
            false => term(r.dot(v).powi(m.shininess), d, m, l),
        };
    }),
    part(SPECULAR, "only r·v above ½ counts", |p| {
        p.specular = |r, v, d, m, l| match r.dot(v) <= 0.5 {
            true => DVec3::ZERO,
            false => term(r.dot(v).powi(m.shininess), d, m, l),
        };
    }),
    part(SPECULAR, "|r·v| is taken", |p| {
        p.specular = |r, v, d, m, l| term(r.dot(v).abs().powi(m.shininess), d, m, l)
    }),
    part(
        SPECULAR,
        "the highlights are multiplied by a + bd + cd², not divided",
        |p| {
            p.specular = |r, v, d, m, l| {
                let fades = l.point.attenuation.at(d);
                term(power(r, v, |c| c.powi(m.shininess)), d, m, l) * fades * fades
            };
        },
    ),
    part(SPECULAR, "the highlights are divided by d, not a + bd + cd²", |p| {
        p.specular = |r, v, d, m, l| {
            let fades = l.point.attenuation.at(d);
            term(power(r, v, |c| c.powi(m.shininess)), d, m, l) * fades / d
        };
    }),
    part(SPECULAR, "the highlights are divided by d², not a + bd + cd²", |p| {
        p.specular = |r, v, d, m, l| {
            let fades = l.point.attenuation.at(d);
            term(power(r, v, |c| c.powi(m.shininess)), d, m, l) * fades / (d * d)
        };
    }),
    part(SPECULAR, "the highlights are divided by a + bd + cd² twice", |p| {
        p.specular = |r, v, d, m, l| {
            let fades = l.point.attenuation.at(d);
            term(power(r, v, |c| c.powi(m.shininess)), d, m, l) / fades
        };
    }),
    part(SPECULAR, "the highlights have R_d · R_s for R_s", |p| {
        p.materials().for_each(|m| m.specular *= m.surface.diffuse)
    }),
    part(SPECULAR, "R_s is left out", |p| {
        p.materials().for_each(|m| m.specular = DVec3::ONE)
    }),
    part(
        SPECULAR,
        "the highlights take the second light's L_s for the first",
        |p| p.scene.lights[0].specular = p.scene.lights[1].specular,
    ),
    part(SPECULAR, "L_s is added, not multiplied", |p| {
        p.specular = |r, v, d, m, l| {
            let power = power(r, v, |c| c.powi(m.shininess));
            match r.dot(v) <= 0.0 {
                true => DVec3::ZERO,
                false => {
                    m.specular / l.point.attenuation.at(d) * power + l.specular
                }
            }
        };
    }),
];
