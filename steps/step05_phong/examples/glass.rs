//! The scene of step 5 with glass: rays that a surface bends by Snell's law and
//! mirrors in Fresnel's part.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step05_phong::{
    AMBIENT_LIGHT, Camera, LIGHTS, MATERIALS, Ray, SPHERES, direction_colour,
    nearest, normal, phong, reflect, render, run,
};

/// The refractive index of each sphere that is of glass.
pub const GLASS: [Option<f64>; 9] =
    [Some(1.5), None, None, None, None, None, Some(1.5), None, None];

/// How many surfaces of glass a ray may meet one after the other.
pub const DEPTH: u32 = 10;

/// How far from a surface the next ray starts, so that it does not meet that surface
/// at once.
pub const OFFSET: f64 = 1e-9;

/// `v` of any length, bent by Snell's law where it meets a surface whose unit normal
/// `n` faces it; or None where the surface mirrors it all.
///
/// `ratio` is η, the refractive index that the ray leaves over the one it enters.
pub fn refract(v: DVec3, n: DVec3, ratio: f64) -> Option<DVec3> {
    let s = ratio * (v - v.dot(n) * n);
    let rest = v.dot(v) - s.dot(s);
    (0.0 <= rest).then(|| s - rest.sqrt() * n)
}

/// The part of unpolarised light that the surface mirrors where `refract` bends `v`
/// to `bent`, by Fresnel's equations; 0 to 1.
pub fn fresnel(v: DVec3, bent: DVec3, n: DVec3, ratio: f64) -> f64 {
    let (c_1, c_2) = (-v.dot(n), -bent.dot(n));
    // For light that swings across the plane of v and n, and within it.
    let across = (ratio * c_1 - c_2) / (ratio * c_1 + c_2);
    let within = (c_1 - ratio * c_2) / (c_1 + ratio * c_2);
    (across * across + within * within) / 2.0
}

/// Says whether a sphere stands between `light` and the point `p` with unit normal
/// `n`; glass lets all of the light through.
pub fn hidden(light: DVec3, p: DVec3, n: DVec3, glass: &[Option<f64>; 9]) -> bool {
    let start = p + OFFSET * n;
    let to_light = Ray { start, direction: light - start };
    SPHERES.iter().zip(glass).any(|(sphere, glass)| {
        let t = sphere.intersect(&to_light).first_hit();
        glass.is_none() && t.is_some_and(|t| t < 1.0)
    })
}

/// The colour that `ray` sees where sphere number i has the refractive index
/// `glass[i]`, by way of at most `depth` surfaces of glass.
pub fn colour(ray: &Ray, glass: &[Option<f64>; 9], depth: u32) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else { return direction_colour(ray) };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let v = -ray.direction.normalize();
    let mut lights = LIGHTS.to_vec();
    lights.retain(|light| !hidden(light.point.position, p, n, glass));
    let terms = phong(p, n, v, &MATERIALS[hit.index], AMBIENT_LIGHT, &lights);
    let Some(index) = glass[hit.index] else { return terms.sum() };
    if depth == 0 {
        return DVec3::ZERO;
    }
    let next = |ray: &Ray| colour(ray, glass, depth - 1);
    terms.specular + through_glass(ray.direction, p, n, index, next)
}

/// What a ray along `v` sees in the surface of glass at `p`, where `next` is the
/// colour that a ray from there sees; `n` points out of the glass.
pub fn through_glass(
    v: DVec3,
    p: DVec3,
    n: DVec3,
    index: f64,
    next: impl Fn(&Ray) -> DVec3,
) -> DVec3 {
    // A ray that leaves the glass meets its surface from within: turn n to face it.
    let (n, ratio) = if v.dot(n) < 0.0 { (n, 1.0 / index) } else { (-n, index) };
    let mirrored = next(&Ray { start: p + OFFSET * n, direction: reflect(-v, n) });
    let Some(bent) = refract(v, n, ratio) else { return mirrored };
    let refracted = next(&Ray { start: p - OFFSET * n, direction: bent });
    let part = fresnel(v, bent, n, ratio);
    part * mirrored + (1.0 - part) * refracted
}

/// The picture: the colour of every ray.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(ray, &GLASS, DEPTH))
}

fn main() -> ExitCode {
    run(env!("CARGO_CRATE_NAME"), picture)
}
