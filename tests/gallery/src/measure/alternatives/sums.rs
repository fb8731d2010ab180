use super::{Alternative, sum};
use crate::section::{AMBIENT, LIGHTS, SUM};
use glam::DVec3;

pub(super) const ALL: &[Alternative] = &[
    sum(AMBIENT, "R_a + L_a is taken for R_a L_a", |parts, l_a| {
        parts[0] = parts[0] / l_a + l_a
    }),
    sum(LIGHTS, "the terms are multiplied, not added", |parts, _| {
        let product = parts[0] * parts[1] * parts[3];
        *parts = [product, DVec3::ZERO, parts[2], DVec3::ZERO, parts[4]];
    }),
    sum(SUM, "I_d is multiplied by I_s, not added", |parts, _| {
        let product = (parts[1] + parts[3]) * (parts[2] + parts[4]);
        *parts = [parts[0], product, DVec3::ZERO, DVec3::ZERO, DVec3::ZERO];
    }),
    sum(SUM, "I_a is multiplied by I_d, not added", |parts, _| {
        let product = parts[0] * (parts[1] + parts[3]);
        *parts = [product, DVec3::ZERO, parts[2], DVec3::ZERO, parts[4]];
    }),
    sum(LIGHTS, "the sum of the diffuse parts begins with 1", |parts, _| {
        parts[0] += DVec3::ONE
    }),
    sum(LIGHTS, "the sum begins with L_a once more", |parts, l_a| parts[0] += l_a),
];
