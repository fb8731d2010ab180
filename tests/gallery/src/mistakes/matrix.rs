//! Mistakes with the nine numbers of the camera matrix.

use crate::{Mistake, Parts, Step, section};
use glam::{DMat3, DVec3};
use step01_rays::Camera;

pub(crate) const ALL: &[Mistake] = &[
    wrong(
        "slide-matrix",
        "the matrix is the slide's, to the letter",
        "Nearly all of the picture has one colour; only its top rows show more.",
        "The D_v of the slide has lost its denominator, so that the second row looks \
         down already.",
        |parts| {
            let Camera { h_res, v_res, matrix, .. } = &mut parts.camera;
            let tan = -matrix.z_axis.x;
            let upright = f64::from(*v_res) * tan / f64::from(*h_res - 1);
            matrix.y_axis.y = -2.0 * upright;
            matrix.z_axis.y = upright;
        },
    ),
    wrong(
        "d-u-in-wrong-row",
        "D_u has its value in the row of y",
        "The picture is slanted streaks, each of one colour.",
        "D_u is one pixel to the right, so its value belongs to x; the first slide has \
         this slip.",
        |parts| {
            let d_u = &mut parts.camera.matrix.x_axis;
            *d_u = DVec3::new(0.0, d_u.x, 0.0);
        },
    ),
    wrong(
        "rows-for-columns",
        "the matrix is given row by row to a function that takes columns",
        "A slanted line cuts the sky, and there are hardly any spheres.",
        "`DMat3::from_cols` takes D_u, D_v and V_0, one after the other.",
        |parts| parts.camera.matrix = parts.camera.matrix.transpose(),
    ),
    wrong(
        "i-j-swapped",
        "i and j change places",
        "The picture is tilted over its diagonal: up has become left.",
        "D_u is multiplied by the column i, D_v by the row j.",
        |parts| {
            let DMat3 { x_axis: d_u, y_axis: d_v, z_axis: v_0 } =
                parts.camera.matrix;
            parts.camera.matrix = DMat3::from_cols(d_v, d_u, v_0);
        },
    ),
    wrong(
        "starts-ahead",
        "V_0 looks straight ahead",
        "The middle of the scene is in the upper left corner.",
        "The first ray goes through the centre of the corner pixel: its x is −tan(θ/2), and its y is above 0.",
        |parts| parts.camera.matrix.z_axis = DVec3::NEG_Z,
    ),
    wrong(
        "half-a-pixel",
        "half a pixel is added to i and j",
        "It looks right, but everything is half a pixel to the left and up.",
        "Where the outermost rays enclose θ, whole numbers are the middles of pixels.",
        |parts| {
            let matrix = &mut parts.camera.matrix;
            matrix.z_axis += 0.5 * (matrix.x_axis + matrix.y_axis);
        },
    ),
    wrong(
        "y-down",
        "y points down",
        "The picture is upside down.",
        "Rows run down and y runs up, so D_v has a minus and V_0 starts at the top.",
        |parts| turned(parts, DVec3::new(1.0, -1.0, 1.0)),
    ),
    wrong(
        "mirrored",
        "x points left",
        "The picture is mirrored: left and right have changed places.",
        "The first column is on the left, at −tan(θ/2), and D_u goes to the right.",
        |parts| turned(parts, DVec3::new(-1.0, 1.0, 1.0)),
    ),
    wrong(
        "looks-back",
        "the camera looks along +z",
        "What is ahead is missing; what is behind the camera may be seen.",
        "The camera looks down −z, so V_0 has a −1.",
        |parts| turned(parts, DVec3::new(1.0, 1.0, -1.0)),
    ),
];

/// Multiplies x, y and z of every direction.
fn turned(parts: &mut Parts, signs: DVec3) {
    parts.camera.matrix = DMat3::from_diagonal(signs) * parts.camera.matrix;
}

const fn wrong(
    name: &'static str,
    when: &'static str,
    sees: &'static str,
    says: &'static str,
    change: fn(&mut Parts),
) -> Mistake {
    let (step, section) = (Step::Rays, section::CAMERA);
    let file = "steps/step01_rays/src/camera.rs";
    Mistake { name, step, file, section, when, sees, says, change }
}
