//! The scene of step 4 at night, in the light of four spot lights.

use glam::DVec3;
use image::RgbImage;
use std::process::ExitCode;
use step04_diffuse::{
    AMBIENT_LIGHT, Attenuation, COLOURS, Camera, PointLight, Ray, SPHERES, Surface,
    ambient, diffuse, direction_colour, nearest, normal, render, run,
};

/// A point light that shines into a cone only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLight {
    /// Its position, L_d and attenuation.
    pub point: PointLight,
    /// A point on the axis of the cone, anywhere but at the light.
    pub target: DVec3,
    /// Up to this angle from the axis the light is whole, in radians.
    pub inner: f64,
    /// From this angle on there is none; above `inner`.
    pub outer: f64,
}

/// How bright the night is, compared with the day of step 4.
pub const NIGHT: f64 = 0.4;

/// The spot lights of the picture.
pub const SPOTS: [SpotLight; 4] = [
    spot(DVec3::new(-1.5, 4.5, -3.0), DVec3::new(-0.5, -1.4, -6.4), 1.0, 0.7, 0.4),
    spot(DVec3::new(-5.0, 4.0, -5.5), DVec3::new(-3.2, -1.0, -8.6), 0.3, 0.6, 1.0),
    spot(DVec3::new(3.0, 4.5, -5.0), DVec3::new(1.8, -0.6, -9.0), 0.9, 0.35, 0.6),
    spot(DVec3::new(3.5, 4.0, -3.0), DVec3::new(3.2, -1.5, -6.2), 0.4, 0.9, 0.8),
];

const fn spot(position: DVec3, target: DVec3, r: f64, g: f64, b: f64) -> SpotLight {
    let attenuation = Attenuation { a: 0.5, b: 0.0, c: 0.01 };
    let point = PointLight { position, diffuse: DVec3::new(r, g, b), attenuation };
    let (inner, outer) = (8_f64.to_radians(), 20_f64.to_radians());
    SpotLight { point, target, inner, outer }
}

impl SpotLight {
    /// The part of its light that goes the way opposite to the unit vector `l`: 1
    /// inside the cone, 0 outside, and a smooth step between.
    pub fn cone(&self, l: DVec3) -> f64 {
        let axis = (self.target - self.point.position).normalize();
        let (inner, outer) = (self.inner.cos(), self.outer.cos());
        let x = ((axis.dot(-l) - outer) / (inner - outer)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    }
}

/// The colour that `ray` sees.
pub fn colour(ray: &Ray) -> DVec3 {
    let Some(hit) = nearest(&SPHERES, ray) else {
        return NIGHT * direction_colour(ray);
    };
    let p = ray.at(hit.t);
    let n = normal(&SPHERES[hit.index], p);
    let surface = Surface::of(COLOURS[hit.index]);
    let mut intensity = NIGHT * ambient(surface.ambient, AMBIENT_LIGHT);
    for spot in &SPOTS {
        let (l, d) = spot.point.seen_from(p);
        intensity += spot.cone(l) * diffuse(n, l, d, surface.diffuse, &spot.point);
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
