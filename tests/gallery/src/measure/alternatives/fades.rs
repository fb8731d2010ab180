use super::{Alternative, part};
use crate::section::ATTENUATION;
use step04_diffuse::{Attenuation as A, PointLight};

pub(super) const ALL: &[Alternative] = &[
    part(ATTENUATION, "the divisor has lost its cd²: a + bd", |p| {
        p.attenuation = |f, d| f.a + f.b * d
    }),
    part(ATTENUATION, "the divisor has lost its bd: a + cd²", |p| {
        p.attenuation = |f, d| f.a + f.c * d * d
    }),
    part(ATTENUATION, "the divisor has lost its a: bd + cd²", |p| {
        p.attenuation = |f, d| f.b * d + f.c * d * d
    }),
    part(ATTENUATION, "the divisor is a alone", |p| p.attenuation = |f, _| f.a),
    part(ATTENUATION, "a and b change places: b + ad + cd²", |p| {
        p.attenuation = |f, d| f.b + f.a * d + f.c * d * d
    }),
    part(ATTENUATION, "a and c change places: c + bd + ad²", |p| {
        p.attenuation = |f, d| f.c + f.b * d + f.a * d * d
    }),
    part(ATTENUATION, "cd² has a minus", |p| {
        p.attenuation = |f, d| f.a + f.b * d - f.c * d * d
    }),
    part(ATTENUATION, "bd has a minus", |p| {
        p.attenuation = |f, d| f.a - f.b * d + f.c * d * d
    }),
    part(ATTENUATION, "c is multiplied by d³", |p| {
        p.attenuation = |f, d| f.a + f.b * d + f.c * d * d * d
    }),
    part(ATTENUATION, "b is multiplied by d², too", |p| {
        p.attenuation = |f, d| f.a + f.b * d * d + f.c * d * d
    }),
    part(ATTENUATION, "it is (a + b) d + cd²", |p| {
        p.attenuation = |f, d| (f.a + f.b) * d + f.c * d * d
    }),
    part(ATTENUATION, "it is (a + bd + c) d²", |p| {
        p.attenuation = |f, d| (f.a + f.b * d + f.c) * d * d
    }),
    part(ATTENUATION, "it is (a + bd) d + cd²", |p| {
        p.attenuation = |f, d| (f.a + f.b * d) * d + f.c * d * d
    }),
    part(ATTENUATION, "it is a·bd + cd²", |p| {
        p.attenuation = |f, d| f.a * f.b * d + f.c * d * d
    }),
    part(ATTENUATION, "it is a + b + cd², without the d of b", |p| {
        p.attenuation = |f, d| f.a + f.b + f.c * d * d
    }),
    part(ATTENUATION, "it is a + bd + c, without the d² of c", |p| {
        p.attenuation = |f, d| f.a + f.b * d + f.c
    }),
    part(ATTENUATION, "a is 1", |p| {
        p.attenuation = |f, d| 1.0 + f.b * d + f.c * d * d
    }),
    part(ATTENUATION, "the divisor is d", |p| p.attenuation = |_, d| d),
    part(ATTENUATION, "the divisor is d²", |p| p.attenuation = |_, d| d * d),
    part(ATTENUATION, "it is divided by the square of a + bd + cd²", |p| {
        p.attenuation = |f, d| f.at(d).powi(2)
    }),
    part(ATTENUATION, "it is divided by the root of a + bd + cd²", |p| {
        p.attenuation = |f, d| f.at(d).sqrt()
    }),
    part(ATTENUATION, "d is squared already: a + bd² + cd⁴", |p| {
        p.attenuation = |f, d| f.at(d * d)
    }),
    part(ATTENUATION, "d is 1/d", |p| p.attenuation = |f, d| f.at(1.0 / d)),
    part(ATTENUATION, "d is 1, as that of a unit vector", |p| {
        p.attenuation = |f, _| f.at(1.0)
    }),
    part(ATTENUATION, "d is half of what it should be", |p| {
        p.attenuation = |f, d| f.at(d / 2.0)
    }),
    part(ATTENUATION, "d is twice what it should be", |p| {
        p.attenuation = |f, d| f.at(2.0 * d)
    }),
    part(ATTENUATION, "d is the distance of the light from the origin", |p| {
        p.seen_from =
            |light, p| (PointLight::seen_from(light, p).0, light.position.length());
    }),
    part(ATTENUATION, "a and b change places, and c is left out", |p| {
        p.attenuation = |f, d| A { a: f.b, b: f.a, c: 0.0 }.at(d)
    }),
];
