use crate::{Camera, OBJECTS, Object, Ray, direction_colour, nearest, render};
use glam::DVec3;
use image::RgbImage;

/// The colour that `ray` sees: that of the nearest object, or else that of the sky.
pub fn colour(objects: &[Object<DVec3>], ray: &Ray) -> DVec3 {
    match nearest(objects, ray) {
        Some(hit) => hit.object.material,
        None => direction_colour(ray),
    }
}

/// The picture of step 3: the objects of the scene, each in its flat colour.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&OBJECTS, ray))
}
