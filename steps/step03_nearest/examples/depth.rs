//! The depth: how far away the nearest hit is, as a grey.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step03_nearest::{Camera, Ray, SPHERES, nearest, render, run};

/// The distance that is white.
const WHITE: f64 = 4.0;

/// The distance that is black.
const BLACK: f64 = 14.0;

/// The distance from the start of `ray` to its nearest hit, t |V|.
pub fn distance(ray: &Ray) -> Option<f64> {
    nearest(&SPHERES, ray).map(|hit| hit.t * ray.direction.length())
}

/// The colour that `ray` sees: the nearer the brighter, black where nothing is hit.
fn colour(ray: &Ray) -> DVec3 {
    let d = distance(ray).unwrap_or(BLACK);
    DVec3::splat((BLACK - d) / (BLACK - WHITE))
}

/// The picture: the scene of step 3, measured.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, colour)
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
