//! Where the exercises of step 3 begin: step 3's own picture.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step03_nearest::{
    COLOURS, Camera, Ray, SPHERES, direction_colour, nearest, render, run,
};

/// The colour that `ray` sees: that of the nearest sphere, else its own direction.
fn colour(ray: &Ray) -> DVec3 {
    match nearest(&SPHERES, ray) {
        Some(hit) => COLOURS[hit.index],
        None => direction_colour(ray),
    }
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
