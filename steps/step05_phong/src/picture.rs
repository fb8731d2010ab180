use crate::{
    AMBIENT_LIGHT, Camera, LIGHTS, MATERIALS, Phong, Ray, SPHERES,
    direction_colour, nearest, normal, phong, render,
};
use glam::DVec3;
use image::RgbImage;

/// The three terms of the light that comes back along `ray`, or None where it meets
/// no sphere.
pub fn terms(ray: &Ray) -> Option<Phong> {
    let hit = nearest(&SPHERES, ray)?;
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let v = -ray.direction.normalize();
    Some(phong(p, n, v, &MATERIALS[hit.index], AMBIENT_LIGHT, &LIGHTS))
}

/// The colour that `ray` sees: the sum of the three terms, otherwise its own
/// direction.
pub fn colour(ray: &Ray) -> DVec3 {
    match terms(ray) {
        Some(terms) => terms.sum(),
        None => direction_colour(ray),
    }
}

/// The picture of step 5, the final one: the scene in the light of the whole Phong
/// sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}
