use crate::live::{Handle, Knob};
use glam::{DVec2, DVec3, dvec2};
use step01_rays::{Camera, Ray};

/// The column of the pixel that is asked.
pub const COLUMN: Knob = Knob::new(["i", "column", ""], 470.0, [0.0, 639.0], 1.0);

/// Its row.
pub const ROW: Knob = Knob::new(["j", "row", ""], 120.0, [0.0, 359.0], 1.0);

/// How many columns the picture has; a page draws them all.
pub const COLUMNS: Knob =
    Knob::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0).fixed();

/// Columns and rows of the pictures of the course.
pub const SIZE: DVec2 = dvec2(640.0, 360.0);

/// The cross at the pixel, for a picture whose first knobs are `COLUMN` and `ROW`.
pub const PIXEL: Handle = Handle {
    words: "the pixel that you ask",
    knobs: [0, 1],
    at: |values| dvec2(values[0], values[1]) + 0.5,
    drag: |values, to| {
        values[..2].copy_from_slice(&(to - 0.5).to_array());
    },
    is_down: true,
    is_asking: true,
};

/// Where in the picture of the course a point of the world is.
pub fn place(p: DVec3) -> DVec2 {
    place_by(&crate::camera(), p)
}

/// Where in the picture of a camera a point of the world is: in
/// p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is how deep it lies. What is behind the eye is
/// left of the picture.
pub fn place_by(camera: &Camera, p: DVec3) -> DVec2 {
    let pixel = camera.matrix.inverse() * (p - camera.centre);
    if pixel.z <= 0.0 {
        return DVec2::NEG_X;
    }
    pixel.truncate() / pixel.z + 0.5
}

/// The point of the world that is seen at a place, `depth` ahead.
pub fn point(place: DVec2, depth: f64) -> DVec3 {
    let pixel = place - 0.5;
    crate::camera().ray(pixel.x, pixel.y).at(depth)
}

/// The camera of a picture of so many columns.
pub fn camera(columns: f64) -> Result<Camera, String> {
    super::step01::camera(&[60.0, 1.0, columns])
}

/// The camera of allowed columns.
pub fn seen(columns: f64) -> Camera {
    camera(columns).unwrap_or_else(|_| crate::camera())
}

/// The ray through the pixel that is asked, in the picture of the course.
pub fn ray(values: &[f64]) -> Ray {
    crate::camera().ray(values[0], values[1])
}
