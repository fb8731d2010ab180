use super::{Alternative, part, vectors};
use crate::section::{AMBIENT, DIFFUSE, LAMBERT, LIGHT, LIGHTS};
use glam::DVec3;
use step04_diffuse::{PointLight, Surface};

/// The diffuse term with another cosine.
fn term(cosine: f64, d: f64, surface: &Surface, light: &PointLight) -> DVec3 {
    surface.diffuse / light.attenuation.at(d) * cosine * light.diffuse
}

pub(super) const ALL: &[Alternative] = &[
    part(LAMBERT, "min(l·n, 0) is taken for max(l·n, 0)", |p| {
        p.diffuse = |n, l, d, s, light| term(l.dot(n).min(0.0), d, s, light)
    }),
    part(LAMBERT, "max(l·n, 1) is taken for max(l·n, 0)", |p| {
        p.diffuse = |n, l, d, s, light| term(l.dot(n).max(1.0), d, s, light)
    }),
    part(LAMBERT, "max(−l·n, 0) is taken: the dark sides are lit", |p| {
        p.diffuse = |n, l, d, s, light| term((-l.dot(n)).max(0.0), d, s, light)
    }),
    part(LAMBERT, "l·n is squared", |p| {
        p.diffuse = |n, l, d, s, light| term(l.dot(n).max(0.0).powi(2), d, s, light)
    }),
    part(LAMBERT, "½ + ½ l·n is taken for l·n", |p| {
        p.diffuse = |n, l, d, s, light| term(0.5 + 0.5 * l.dot(n), d, s, light)
    }),
    part(LAMBERT, "½ + ½ l·n, squared, is taken for l·n", |p| {
        p.diffuse =
            |n, l, d, s, light| term((0.5 + 0.5 * l.dot(n)).powi(2), d, s, light)
    }),
    part(LAMBERT, "the sine is taken for the cosine", |p| {
        p.diffuse = |n, l, d, s, light| {
            term((1.0 - l.dot(n).powi(2)).max(0.0).sqrt(), d, s, light)
        }
    }),
    part(LAMBERT, "1 − l·n is taken for l·n", |p| {
        p.diffuse = |n, l, d, s, light| term(1.0 - l.dot(n).max(0.0), d, s, light)
    }),
    part(LAMBERT, "the root of l·n is taken", |p| {
        p.diffuse = |n, l, d, s, light| term(l.dot(n).max(0.0).sqrt(), d, s, light)
    }),
    part(LAMBERT, "the angle between l and n is taken for its cosine", |p| {
        p.diffuse =
            |n, l, d, s, light| term(l.dot(n).clamp(-1.0, 1.0).acos(), d, s, light)
    }),
    part(LAMBERT, "l·n and n·n change places: the cosine is always 1", |p| {
        p.diffuse = |n, _, d, s, light| term(n.dot(n), d, s, light)
    }),
    vectors(DIFFUSE, "the diffuse term has v for l", 1, |v| v.l = v.v),
    vectors(DIFFUSE, "the diffuse term has v for n", 1, |v| v.n = v.v),
    vectors(DIFFUSE, "the diffuse term has p for n", 1, |v| v.n = v.p),
    vectors(DIFFUSE, "the diffuse term has p for l", 1, |v| v.l = v.p),
    vectors(DIFFUSE, "the diffuse term has V for l", 1, |v| v.l = v.ray.direction),
    vectors(DIFFUSE, "the diffuse term has V for n", 1, |v| v.n = v.ray.direction),
    vectors(DIFFUSE, "the diffuse term has r for l", 1, |v| v.l = v.r),
    vectors(DIFFUSE, "the diffuse term has a d of 1", 1, |v| v.d = 1.0),
    vectors(DIFFUSE, "the diffuse term has d² for d", 1, |v| v.d *= v.d),
    vectors(DIFFUSE, "the diffuse term has 1/d for d", 1, |v| v.d = 1.0 / v.d),
    part(DIFFUSE, "the diffuse term is not divided by a + bd + cd²", |p| {
        p.diffuse = |n, l, d, s, light| {
            term(l.dot(n).max(0.0), d, s, light) * light.attenuation.at(d)
        };
    }),
    part(
        DIFFUSE,
        "the diffuse term is multiplied by a + bd + cd², not divided",
        |p| {
            p.diffuse = |n, l, d, s, light| {
                term(l.dot(n).max(0.0), d, s, light)
                    * light.attenuation.at(d).powi(2)
            };
        },
    ),
    part(
        DIFFUSE,
        "the diffuse term is divided by a + bd + cd² twice, by its square",
        |p| {
            p.diffuse = |n, l, d, s, light| {
                term(l.dot(n).max(0.0), d, s, light) / light.attenuation.at(d)
            };
        },
    ),
    vectors(LIGHT, "the light is seen from n, not from p", 0, |v| v.p = v.n),
    vectors(LIGHT, "the light is seen from S, not from p", 0, |v| {
        v.p = v.ray.start
    }),
    vectors(LIGHT, "the light is seen from V, not from p", 0, |v| {
        v.p = v.ray.direction
    }),
    part(LIGHT, "l is position + p", |p| {
        p.seen_from = |light, p| {
            let l = light.position + p;
            (l.normalize(), l.length())
        }
    }),
    part(LIGHT, "l is p − position, and d with it", |p| {
        p.seen_from = |light, p| {
            let (l, d) = light.seen_from(p);
            (-l, d)
        }
    }),
    part(LIGHT, "l and d are those of the light's position, without p", |p| {
        p.seen_from =
            |light, _| (light.position.normalize(), light.position.length())
    }),
    part(LIGHT, "l is −p, without the position", |p| {
        p.seen_from = |_, p| (-p.normalize(), p.length())
    }),
    part(LIGHT, "l is p, without the position", |p| {
        p.seen_from = |_, p| (p.normalize(), p.length())
    }),
    part(LIGHT, "l is divided by d²", |p| {
        p.seen_from = |light, p| {
            let (l, d) = light.seen_from(p);
            (l / d, d)
        }
    }),
    part(LIGHT, "l is divided by the root of d", |p| {
        p.seen_from = |light, p| {
            let (l, d) = light.seen_from(p);
            (l * d.sqrt(), d)
        }
    }),
    part(DIFFUSE, "R_d is squared", |p| {
        p.materials().for_each(|m| m.surface.diffuse *= m.surface.diffuse)
    }),
    part(DIFFUSE, "R_d is 1 − colour", |p| {
        p.materials().for_each(|m| m.surface.diffuse = 1.0 - m.surface.diffuse)
    }),
    part(DIFFUSE, "the light is divided by R_d", |p| {
        p.materials().for_each(|m| m.surface.diffuse = 1.0 / m.surface.diffuse)
    }),
    part(DIFFUSE, "R_s stands for R_d", |p| {
        p.materials().for_each(|m| m.surface.diffuse = m.specular)
    }),
    part(DIFFUSE, "light of the surface's colour is added, R_d + …", |p| {
        p.diffuse = |n, l, d, s, light| {
            s.diffuse + term(l.dot(n).max(0.0), d, &Surface::of(DVec3::ONE), light)
        }
    }),
    part(LIGHTS, "every light is the first, the warm one", |p| {
        p.scene.lights[1] = p.scene.lights[0]
    }),
    part(LIGHTS, "every light is the second, the cool one", |p| {
        p.scene.lights[0] = p.scene.lights[1]
    }),
    part(
        LIGHTS,
        "the cool light is at the place of the warm one, with its fading and its L_d",
        |p| p.scene.lights[1].point = p.scene.lights[0].point,
    ),
    part(LIGHTS, "the two positions change places", |p| {
        let [a, b] = [0, 1].map(|k| p.scene.lights[k].point.position);
        p.scene.lights[0].point.position = b;
        p.scene.lights[1].point.position = a;
    }),
    part(LIGHTS, "a, b and c of the two lights change places", |p| {
        let [a, b] = [0, 1].map(|k| p.scene.lights[k].point.attenuation);
        p.scene.lights[0].point.attenuation = b;
        p.scene.lights[1].point.attenuation = a;
    }),
    part(AMBIENT, "R_a is squared", |p| {
        p.materials().for_each(|m| m.surface.ambient *= m.surface.ambient)
    }),
    part(AMBIENT, "R_a is 1 − colour", |p| {
        p.materials().for_each(|m| m.surface.ambient = 1.0 - m.surface.ambient)
    }),
    part(AMBIENT, "R_s stands for R_a", |p| {
        p.materials().for_each(|m| m.surface.ambient = m.specular)
    }),
];
