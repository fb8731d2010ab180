//! Where the exercises of step 4 begin: step 4's own picture.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step04_diffuse::{
    AMBIENT_LIGHT, COLOURS, Camera, LIGHTS, Ray, SPHERES, Surface, ambient,
    diffuse, direction_colour, nearest, normal, render, run,
};

/// The colour that `ray` sees: the nearest sphere in the light of this step.
fn colour(ray: &Ray) -> DVec3 {
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

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
