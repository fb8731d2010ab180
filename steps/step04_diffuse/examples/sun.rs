//! The scene of step 4 in the light of a low sun, in the place of its warm light.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step04_diffuse::{
    AMBIENT_LIGHT, COLOURS, Camera, LIGHTS, Ray, SPHERES, Surface, ambient,
    diffuse, direction_colour, nearest, normal, render, run,
};

/// A light so far away that it shines from the same side everywhere, and as bright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// The way to it, of any length but 0.
    pub direction: DVec3,
    /// L_d, its intensity in red, green and blue; 0 or more.
    pub diffuse: DVec3,
}

/// The sun of the picture.
pub const SUN: Sun = Sun {
    direction: DVec3::new(-4.0, 2.0, 1.0),
    diffuse: DVec3::new(1.0, 0.84, 0.64),
};

impl Sun {
    /// Its diffuse term, I_d = R_d · max(l·n, 0) · L_d: l is the same for every
    /// point, and no distance weakens the light.
    pub fn diffuse(&self, n: DVec3, r_d: DVec3) -> DVec3 {
        let l = self.direction.normalize();
        r_d * l.dot(n).max(0.0) * self.diffuse
    }
}

/// The colour that `ray` sees.
pub fn colour(ray: &Ray) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else { return direction_colour(ray) };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let surface = Surface::of(COLOURS[hit.index]);
    let cool = &LIGHTS[1];
    let (l, d) = cool.seen_from(p);
    ambient(surface.ambient, AMBIENT_LIGHT)
        + SUN.diffuse(n, surface.diffuse)
        + diffuse(n, l, d, surface.diffuse, cool)
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
