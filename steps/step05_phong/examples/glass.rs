//! The scene of step 5 with glass, which bends light by Snell's law and mirrors
//! some of it, as much as Fresnel's equations say.

#[path = "mirror.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod mirror;

use glam::DVec3;
use image::RgbImage;
use mirror::{OFFSET, hidden, shadowed_phong};
use std::slice;
use step05_phong::{
    Camera, Light, Material, Object, Ray, Scene, SurfacePoint, direction_colour,
    draw_and_save, reflect, render, scene, visible_point,
};

/// A material that may be glass.
#[derive(Debug)]
pub struct Glass {
    /// Its material. If it is glass, only the material's highlights are seen.
    pub material: Material,
    /// The refractive index, or None if it isn't glass.
    pub index: Option<f64>,
}

/// The scene of step 5, with its red and its white sphere made of glass with this
/// refractive index.
pub fn glasses(index: f64) -> Scene<Glass, Light> {
    let Scene { objects, ambient_light, lights } = scene();
    let objects = objects.into_iter().map(|object| {
        let is_glass = ["red sphere", "white sphere"].contains(&object.name);
        let (material, index) = (object.material, is_glass.then_some(index));
        object.with_material(Glass { material, index })
    });
    Scene { objects: objects.collect(), ambient_light, lights }
}

/// Bends `v`, of any length, by Snell's law where it meets a surface whose unit
/// normal `n` faces it. Returns None if all light is mirrored.
///
/// `ratio` is η, the refractive index on the side that the ray leaves divided by
/// that on the side that it enters.
pub fn refract(v: DVec3, n: DVec3, ratio: f64) -> Option<DVec3> {
    let s = ratio * (v - v.dot(n) * n);
    let rest = v.dot(v) - s.dot(s);
    (rest >= 0.0).then(|| s - rest.sqrt() * n)
}

/// The fraction of unpolarised light that the surface mirrors if `refract` bends
/// `v` to `bent`: from 0 to 1, by Fresnel's equations.
pub fn fresnel(v: DVec3, bent: DVec3, n: DVec3, ratio: f64) -> f64 {
    let (c_1, c_2) = (-v.dot(n), -bent.dot(n));
    // For light that oscillates across the plane of v and n, and within it.
    let across = (ratio * c_1 - c_2) / (ratio * c_1 + c_2);
    let within = (c_1 - ratio * c_2) / (c_1 + ratio * c_2);
    (across * across + within * within) / 2.0
}

/// Whether anything except glass is between `point` and a light at `q`.
pub fn hidden_by_opaque(
    objects: &[Object<Glass>],
    point: &SurfacePoint<Glass>,
    q: DVec3,
) -> bool {
    let mut opaque =
        objects.iter().filter(|object| object.material.index.is_none());
    opaque.any(|object| hidden(slice::from_ref(object), point, q, OFFSET))
}

/// The colour that `ray` sees after meeting at most `depth` glass surfaces.
pub fn colour(scene: &Scene<Glass, Light>, ray: &Ray, depth: u32) -> DVec3 {
    let Some(point) = visible_point(&scene.objects, ray) else {
        return direction_colour(ray);
    };
    let is_hidden = |light: &Light| {
        hidden_by_opaque(&scene.objects, &point, light.point_light.position)
    };
    let Glass { material, index } = point.material();
    let terms = shadowed_phong(&point, ray, material, scene, is_hidden);
    let Some(index) = *index else { return terms.sum() };
    if depth == 0 {
        return DVec3::ZERO;
    }
    let next = |ray: &Ray| colour(scene, ray, depth - 1);
    terms.specular + through_glass(ray, &point, index, next)
}

/// The colour that `ray` sees where it meets a glass surface, at `point`. `next`
/// returns the colour that a ray from there sees.
pub fn through_glass<M>(
    ray: &Ray,
    point: &SurfacePoint<M>,
    index: f64,
    next: impl Fn(&Ray) -> DVec3,
) -> DVec3 {
    let (v, p, n) = (ray.direction, point.p, point.n);
    // A ray that leaves the glass meets its surface from within: turn n to face it.
    let (n, ratio) = if v.dot(n) < 0.0 { (n, 1.0 / index) } else { (-n, index) };
    let mirrored = next(&Ray { start: p + OFFSET * n, direction: reflect(n, -v) });
    let Some(bent) = refract(v, n, ratio) else { return mirrored };
    let refracted = next(&Ray { start: p - OFFSET * n, direction: bent });
    let part = fresnel(v, bent, n, ratio);
    part * mirrored + (1.0 - part) * refracted
}

/// The picture: a ray may meet ten glass surfaces, one after the other.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = glasses(1.5);
    render(camera, samples, |ray| colour(&scene, ray, 10))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
