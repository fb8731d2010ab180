use crate::{
    AMBIENT_LIGHT, COLOURS, Camera, LIGHTS, Ray, SPHERES, Surface, ambient,
    diffuse, direction_colour, nearest, normal, render,
};
use glam::DVec3;
use image::RgbImage;

/// The colour that `ray` sees: the nearest sphere in ambient and diffuse light,
/// otherwise its own direction.
pub fn colour(ray: &Ray) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else { return direction_colour(ray) };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let surface = Surface::of(COLOURS[hit.index]);
    let mut intensity = ambient(surface.ambient, AMBIENT_LIGHT);
    for light in &LIGHTS {
        let (l, d) = light.seen_from(p);
        intensity += diffuse(n, l, d, surface.diffuse, light);
    }
    intensity
}

/// The picture of step 4: the scene in ambient and diffuse light.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}
