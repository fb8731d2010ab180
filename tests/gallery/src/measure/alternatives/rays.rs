use super::{Alternative, part};
use crate::section::{CAMERA, DIRECTIONS, PROGRAM};
use glam::{DMat3, DVec3};
use step01_rays::{Ray, direction_colour};

pub(super) const ALL: &[Alternative] = &[
    part(PROGRAM, "the angle is multiplied by π/180 twice", |parts| {
        let scale = (60_f64.to_radians() / 2.0).to_radians().tan()
            / (60_f64.to_radians() / 2.0).tan();
        let scale = DMat3::from_diagonal(DVec3::new(scale, scale, 1.0));
        parts.camera.matrix = scale * parts.camera.matrix;
    }),
    part(CAMERA, "V_0, D_u and D_v are the columns in this order", |parts| {
        let m = parts.camera.matrix;
        parts.camera.matrix = DMat3::from_cols(m.z_axis, m.x_axis, m.y_axis);
    }),
    part(CAMERA, "D_v, V_0 and D_u are the columns in this order", |parts| {
        let m = parts.camera.matrix;
        parts.camera.matrix = DMat3::from_cols(m.y_axis, m.z_axis, m.x_axis);
    }),
    part(CAMERA, "V_0 and D_v change places", |parts| {
        let m = parts.camera.matrix;
        parts.camera.matrix = DMat3::from_cols(m.x_axis, m.z_axis, m.y_axis);
    }),
    part(CAMERA, "D_u has its value in the row of z", |parts| {
        let x = parts.camera.matrix.x_axis.x;
        parts.camera.matrix.x_axis = DVec3::Z * x;
    }),
    part(CAMERA, "D_v has its value in the row of z", |parts| {
        let y = parts.camera.matrix.y_axis.y;
        parts.camera.matrix.y_axis = DVec3::Z * y;
    }),
    part(CAMERA, "V_0 has a z of −2", |parts| {
        parts.camera.matrix.z_axis.z = -2.0
    }),
    part(CAMERA, "C is not the origin, but (0, 1, 0)", |parts| {
        parts.camera.centre = DVec3::Y;
    }),
    part(CAMERA, "C is not the origin, but (0, 0, −1)", |parts| {
        parts.camera.centre = DVec3::NEG_Z;
    }),
    part(CAMERA, "C is not the origin, but (0, 0, 1)", |parts| {
        parts.camera.centre = DVec3::Z;
    }),
    part(
        CAMERA,
        "V_0 is left out, so that i and j count from the middle",
        |parts| {
            parts.camera.matrix.z_axis = DVec3::ZERO;
        },
    ),
    part(DIRECTIONS, "the sky is black", |parts| parts.miss = |_| DVec3::ZERO),
    part(DIRECTIONS, "the sky is white", |parts| parts.miss = |_| DVec3::ONE),
    part(DIRECTIONS, "the sky shows S, which is 0: 0.7 everywhere", |parts| {
        parts.miss = |_| DVec3::splat(0.7);
    }),
    part(DIRECTIONS, "the sky shows unit vectors", |parts| {
        parts.miss = |ray| {
            direction_colour(&Ray { direction: ray.direction.normalize(), ..*ray })
        };
    }),
    part(
        DIRECTIONS,
        "the sky shows |V_x|, |V_y| and |V_z|, without their signs",
        |parts| {
            parts.miss = |ray| 0.7 + 0.3 * ray.direction.abs();
        },
    ),
    part(
        DIRECTIONS,
        "red and blue change places in the sky: −V_z, V_y, V_x",
        |parts| {
            parts.miss =
                |&Ray { direction: v, .. }| 0.7 + 0.3 * DVec3::new(-v.z, v.y, v.x);
        },
    ),
    part(
        DIRECTIONS,
        "green and blue change places in the sky: V_x, −V_z, V_y",
        |parts| {
            parts.miss =
                |&Ray { direction: v, .. }| 0.7 + 0.3 * DVec3::new(v.x, -v.z, v.y);
        },
    ),
];
