//! Where the exercises of step 5 begin: step 5's own picture.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step05_phong::{
    AMBIENT_LIGHT, Camera, LIGHTS, MATERIALS, Ray, SPHERES, ambient, diffuse,
    direction_colour, nearest, normal, reflect, render, run, specular,
};

/// The colour that `ray` sees: the nearest sphere in the light of this step.
fn colour(ray: &Ray) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else { return direction_colour(ray) };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let v = -ray.direction.normalize();
    let material = &MATERIALS[hit.index];
    let mut intensity = ambient(material.surface.ambient, AMBIENT_LIGHT);
    for light in &LIGHTS {
        let (l, d) = light.point.seen_from(p);
        intensity += diffuse(n, l, d, material.surface.diffuse, &light.point);
        if 0.0 < n.dot(l) {
            intensity += specular(reflect(l, n), v, d, material, light);
        }
    }
    intensity
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
