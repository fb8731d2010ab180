//! The scene of step 4 with shadows: a light counts where no sphere stands before it.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step04_diffuse::{
    AMBIENT_LIGHT, COLOURS, Camera, LIGHTS, Ray, SPHERES, Surface, ambient,
    diffuse, direction_colour, nearest, normal, render, run,
};

/// How far above the surface a ray to a light starts.
///
/// From `p` itself, whose last digits are rounded, it might hit the surface that `p`
/// lies on.
pub const OFFSET: f64 = 1e-9;

/// Says whether a sphere stands between `light` and the point `p` with unit normal
/// `n`.
///
/// V is the whole way to the light, so the light is at t = 1.
pub fn hidden(light: DVec3, p: DVec3, n: DVec3) -> bool {
    let start = p + OFFSET * n;
    let to_light = Ray { start, direction: light - start };
    nearest(&SPHERES, &to_light).is_some_and(|hit| hit.t < 1.0)
}

/// The colour that `ray` sees.
pub fn colour(ray: &Ray) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else { return direction_colour(ray) };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let surface = Surface::of(COLOURS[hit.index]);
    let mut intensity = ambient(surface.ambient, AMBIENT_LIGHT);
    for light in &LIGHTS {
        if hidden(light.position, p, n) {
            continue;
        }
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
