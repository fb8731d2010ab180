//! The scene of step 5 with mirrors and shadows: the whole of the lecture's
//! "Ray-Tracing Algorithm".

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step05_phong::{
    AMBIENT_LIGHT, Camera, LIGHTS, MATERIALS, Ray, SPHERES, direction_colour,
    nearest, normal, phong, reflect, render, run,
};

/// k, the part of its colour that each sphere mirrors, 0 to 1; the rest is its own.
pub const MIRRORS: [f64; 9] = [0.15, 0.25, 0.4, 0.15, 0.0, 0.25, 0.85, 0.1, 0.0];

/// How many mirrors a ray may meet one after the other.
pub const DEPTH: u32 = 10;

/// How far above a surface the next ray starts, so that it does not meet that
/// surface again.
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

/// The colour that `ray` sees where sphere number i mirrors the part `mirrors[i]`,
/// by way of at most `depth` mirrors.
pub fn colour(ray: &Ray, mirrors: &[f64; 9], depth: u32) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else { return direction_colour(ray) };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let v = -ray.direction.normalize();
    let mut lights = LIGHTS.to_vec();
    lights.retain(|light| !hidden(light.point.position, p, n));
    let terms = phong(p, n, v, &MATERIALS[hit.index], AMBIENT_LIGHT, &lights);
    let k = mirrors[hit.index];
    if k == 0.0 || depth == 0 {
        return terms.sum();
    }
    let mirrored =
        Ray { start: p + OFFSET * n, direction: reflect(-ray.direction, n) };
    (1.0 - k) * (terms.ambient + terms.diffuse)
        + k * colour(&mirrored, mirrors, depth - 1)
        + terms.specular
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(ray, &MIRRORS, DEPTH))
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
