//! What the steps' own functions make of one pixel of the final picture.

use super::measure::camera;
use glam::DVec3;
use std::sync::LazyLock;
use step05_phong::{
    Light, Material, Object, Phong, Ray, Scene, SurfacePoint, diffuse, nearest,
    reflect, scene, specular, terms, visible_point,
};

pub static SCENE: LazyLock<Scene<Material, Light>> = LazyLock::new(scene);

/// The pixel of the worked examples: its column i and its row j.
pub const PIXEL: (u32, u32) = (470, 120);

/// The ray through it.
pub fn ray() -> Ray {
    camera().ray(PIXEL.0.into(), PIXEL.1.into())
}

/// Where that ray meets the nearest object, and the object.
pub fn hit() -> (f64, Object<Material>) {
    let hit = nearest(&SCENE.objects, &ray()).expect(SEES);
    (hit.t, *hit.object)
}

/// The terms of the light at that point.
pub fn example() -> Phong {
    terms(&SCENE, &ray()).expect(SEES)
}

/// The warm light at that point.
pub fn warm() -> Lit {
    lit(PIXEL, 0)
}

/// The cool light at that point.
pub fn cool() -> Lit {
    lit(PIXEL, 1)
}

/// A point that a pixel sees, and one light as it falls there.
pub struct Lit {
    pub point: SurfacePoint<'static, Material>,
    pub l: DVec3,
    pub d: f64,
    pub r: DVec3,
    pub v: DVec3,
    /// n·l.
    pub cosine: f64,
    /// r·v.
    pub alignment: f64,
    /// I_d of this light alone.
    pub diffuse: DVec3,
    /// I_s of this light alone, whether or not it faces the surface.
    pub specular: DVec3,
}

/// What a light of the scene does to what a pixel sees.
pub fn lit((i, j): (u32, u32), light: usize) -> Lit {
    let ray = camera().ray(i.into(), j.into());
    let point = visible_point(&SCENE.objects, &ray).expect(SEES);
    let (material, light) = (point.material, &SCENE.lights[light]);
    let (l, d) = light.point_light.direction_from(point.p);
    let (r, v) = (reflect(point.n, l), -ray.direction.normalize());
    let (cosine, alignment) = (point.n.dot(l), r.dot(v));
    let diffuse = diffuse(point.n, l, d, &material.surface, &light.point_light);
    let specular = specular(r, v, d, material, light);
    Lit { point, l, d, r, v, cosine, alignment, diffuse, specular }
}

const SEES: &str = "the pixel sees an object";
