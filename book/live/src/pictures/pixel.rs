//! The pixel of a picture that its reader asks.

use super::step01;
use crate::live::{Handle, Knob};
use glam::{DVec2, DVec3, dvec2};
use step01_rays::{Camera, Ray};

/// Columns and rows of the pictures of the course.
pub const SIZE: DVec2 = dvec2(640.0, 360.0);

/// The first knobs of a picture that can be asked: the column and the row of the pixel,
/// and the columns of the picture.
pub fn knobs(i: f64, j: f64) -> Vec<Knob> {
    vec![
        Knob::new(["i", "column", ""], i, [0.0, SIZE.x - 1.0], 1.0),
        Knob::new(["j", "row", ""], j, [0.0, SIZE.y - 1.0], 1.0),
        columns(),
    ]
}

/// How many columns a picture has; a page draws them all.
pub fn columns() -> Knob {
    let knob = Knob::new(["hRes", "columns", ""], SIZE.x, [2.0, SIZE.x], 1.0);
    Knob { is_shown: |_, _| false, ..knob }
}

/// The camera of these values.
pub fn camera(values: &[f64]) -> Camera {
    step01::camera(&[60.0, 1.0, values[2]])
}

/// The ray through the pixel, in the picture of the course.
pub fn ray(values: &[f64]) -> Ray {
    crate::camera().ray(values[0], values[1])
}

/// The cross at the pixel.
pub fn cross() -> Handle {
    let at = |handle: &Handle, values: &[f64]| handle.point(values) + 0.5;
    let words = "the pixel that you ask";
    let handle = Handle::new(words, [0, 1], at, |_, _, to| to - 0.5);
    Handle { is_down: true, is_asking: true, ..handle }
}

/// Where in the picture of a camera a point of the world is: in
/// p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is how deep it lies. What is behind the eye is
/// left of the picture.
pub fn place(camera: &Camera, p: DVec3) -> DVec2 {
    let pixel = camera.matrix.inverse() * (p - camera.centre);
    if pixel.z <= 0.0 {
        return DVec2::NEG_X;
    }
    pixel.truncate() / pixel.z + 0.5
}

/// The point of the world that is seen at a place, as deep as z = `z`.
pub fn point(camera: &Camera, place: DVec2, z: f64) -> DVec2 {
    let pixel = place - 0.5;
    camera.ray(pixel.x, pixel.y).at(-z).truncate()
}
