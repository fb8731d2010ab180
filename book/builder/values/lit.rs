//! What the steps' own functions make of one pixel of the final picture.

use super::worked::camera;
use glam::DVec3;
use std::sync::LazyLock;
use step05_phong::{
    Light, Material, Object, Phong, Point, Ray, Scene, diffuse, nearest, reflect,
    scene, seen, specular, terms,
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
    Lit::at(PIXEL, 0)
}

/// The cool light at that point.
pub fn cool() -> Lit {
    Lit::at(PIXEL, 1)
}

/// A point that a pixel sees, and one light as it falls there.
pub struct Lit {
    pub point: Point<'static, Material>,
    pub light: Light,
    pub l: DVec3,
    pub d: f64,
    pub r: DVec3,
    pub v: DVec3,
}

impl Lit {
    /// The pixel has to see an object.
    pub fn at((i, j): (u32, u32), light: usize) -> Self {
        let ray = camera().ray(i.into(), j.into());
        let point = seen(&SCENE.objects, &ray).expect(SEES);
        let light = SCENE.lights[light];
        let (l, d) = light.point.seen_from(point.p);
        let (r, v) = (reflect(l, point.n), -ray.direction.normalize());
        Self { point, light, l, d, r, v }
    }

    /// n·l.
    pub fn cosine(&self) -> f64 {
        self.point.n.dot(self.l)
    }

    /// r·v.
    pub fn alignment(&self) -> f64 {
        self.r.dot(self.v)
    }

    /// I_d of this light alone.
    pub fn diffuse(&self) -> DVec3 {
        let Self { point, light, l, d, .. } = self;
        diffuse(point.n, *l, *d, &point.material.surface, &light.point)
    }

    /// I_s of this light alone, whether or not it faces the surface.
    pub fn specular(&self) -> DVec3 {
        specular(self.r, self.v, self.d, self.point.material, &self.light)
    }
}

const SEES: &str = "the pixel sees an object";
