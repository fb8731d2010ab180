//! The way from the world to the pixels of a picture, and back.

use glam::{DVec2, DVec3, dvec2};
use step01_rays::Camera;

/// Columns and rows of the pictures of the course.
pub const SIZE: DVec2 = dvec2(640.0, 360.0);

/// The place of a point of the world in the picture of a camera; None behind the eye.
///
/// In p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is the depth.
pub fn place_of_point(camera: &Camera, p: DVec3) -> Option<DVec2> {
    let pixel = camera.matrix.inverse() * (p - camera.centre);
    (0.0 < pixel.z).then(|| pixel.truncate() / pixel.z + 0.5)
}

/// The x and y of the point of the world at a place in the picture and at this z; None
/// where the ray of that place leads to no such point.
pub fn point_at_place(camera: &Camera, place: DVec2, z: f64) -> Option<DVec2> {
    let pixel = place - 0.5;
    let ray = camera.ray(pixel.x, pixel.y);
    let t = (z - ray.start.z) / ray.direction.z;
    (0.0 < t && t.is_finite()).then(|| ray.at(t).truncate())
}
