//! Mistakes with the nine numbers of the camera matrix.

use crate::mistake::book;
use crate::{Mistake, Parts, section};
use glam::{DMat3, DVec3};
use step01_rays::Camera;

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "slide-matrix",
        when: "the matrix is the slide's, to the letter",
        sees: book("Below its first few rows, nothing changes from top to bottom."),
        says: "The D_v of the slide has lost its denominator, so that the second row looks \
         down already.",
        change: |parts| {
            let Camera { h_res, v_res, matrix, .. } = &mut parts.camera;
            let tan = -matrix.z_axis.x;
            let upright = f64::from(*v_res) * tan / f64::from(*h_res - 1);
            matrix.y_axis.y = -2.0 * upright;
            matrix.z_axis.y = upright;
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "d-u-in-wrong-row",
        when: "D_u has its value in the row of y",
        sees: book("The picture is slanted streaks, each of one colour."),
        says: "D_u is one pixel to the right, so its value belongs to x; the first slide has \
         this slip.",
        change: |parts| {
            let d_u = &mut parts.camera.matrix.x_axis;
            *d_u = DVec3::new(0.0, d_u.x, 0.0);
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "rows-for-columns",
        when: "the matrix is given row by row to a function that takes columns",
        sees: book(
            "A slanted line cuts the sky; from step 2 on, red fills nearly all of the picture.",
        ),
        says: "`DMat3::from_cols` takes D_u, D_v and V_0, one after the other.",
        change: |parts| parts.camera.matrix = parts.camera.matrix.transpose(),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "i-j-swapped",
        when: "i and j change places",
        sees: book("The picture is transposed: up has become left."),
        says: "D_u is multiplied by the column i, D_v by the row j.",
        change: |parts| {
            let DMat3 { x_axis: d_u, y_axis: d_v, z_axis: v_0 } =
                parts.camera.matrix;
            parts.camera.matrix = DMat3::from_cols(d_v, d_u, v_0);
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "starts-ahead",
        when: "V_0 looks straight ahead",
        sees: book("The middle of the scene is in the upper left corner."),
        says: "The first ray goes through the centre of the corner pixel: its x is −tan(θ/2), and its y is above 0.",
        change: |parts| parts.camera.matrix.z_axis = DVec3::NEG_Z,
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "half-a-pixel",
        when: "half a pixel is added to i and j",
        sees: book(
            "It looks right, but everything is half a pixel to the left and up.",
        ),
        says: "Where the outermost rays enclose θ, whole numbers are the middles of pixels.",
        change: |parts| {
            let matrix = &mut parts.camera.matrix;
            matrix.z_axis += 0.5 * (matrix.x_axis + matrix.y_axis);
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "y-down",
        when: "y points down",
        sees: book("The picture is upside down."),
        says: "Rows run down and y runs up, so D_v has a minus and V_0 starts at the top.",
        change: |parts| turned(parts, DVec3::new(1.0, -1.0, 1.0)),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "mirrored",
        when: "x points left",
        sees: book("The picture is mirrored: left and right have changed places."),
        says: "The first column is on the left, at −tan(θ/2), and D_u goes to the right.",
        change: |parts| turned(parts, DVec3::new(-1.0, 1.0, 1.0)),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "looks-back",
        when: "the camera looks along +z",
        sees: book("The sky is green and orange, and what is ahead is missing."),
        says: "The camera looks down −z, so V_0 has a −1.",
        change: |parts| turned(parts, DVec3::new(1.0, 1.0, -1.0)),
        ..section::CAMERA.mistake()
    },
];

/// Multiplies x, y and z of every direction.
fn turned(parts: &mut Parts, signs: DVec3) {
    parts.camera.matrix = DMat3::from_diagonal(signs) * parts.camera.matrix;
}
