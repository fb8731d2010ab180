//! The scene of step 5 with Blinn's highlights, from the vector halfway between l
//! and v.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step05_phong::{
    AMBIENT_LIGHT, Camera, LIGHTS, Light, MATERIALS, Material, Ray, SPHERES,
    ambient, diffuse, direction_colour, nearest, normal, render, run,
};

/// h, the unit vector halfway between the unit vectors `l` and `v`, which are not
/// opposite: h = (l + v) / |l + v|.
pub fn halfway(l: DVec3, v: DVec3) -> DVec3 {
    (l + v).normalize()
}

/// The specular term with the cosine between n and h:
/// I_s = R_s / (a + bd + cd²) · max(n·h, 0)⁴ⁿ · L_s.
///
/// Where light and eye are on nearly the same side, h is half as far from n as v is
/// from r, so the exponent is four times the shininess.
pub fn specular(
    n: DVec3,
    h: DVec3,
    d: f64,
    material: &Material,
    light: &Light,
) -> DVec3 {
    material.specular / light.point.attenuation.at(d)
        * n.dot(h).max(0.0).powi(4 * material.shininess)
        * light.specular
}

/// The colour that `ray` sees.
pub fn colour(ray: &Ray) -> DVec3 {
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
            intensity += specular(n, halfway(l, v), d, material, light);
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
