use crate::{
    Light, Material, Ray, SurfacePoint, ambient, diffuse, reflect, specular,
};
use glam::DVec3;

/// The terms of the light that leaves a point; I_d and I_s are sums over all lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// I_a, of the light that is the same everywhere.
    pub ambient: DVec3,
    /// I_d, scattered all around.
    pub diffuse: DVec3,
    /// I_s, mirrored.
    pub specular: DVec3,
}

impl Phong {
    /// I = I_a + I_d + I_s.
    pub fn sum(&self) -> DVec3 {
        self.ambient + self.diffuse + self.specular
    }
}

/// The light that comes back along `ray` from `point` (slide "Phong Lighting").
/// A light behind the surface gives no highlight; the slide has no such rule.
pub fn phong(
    point: &SurfacePoint<Material>,
    ray: &Ray,
    ambient_light: DVec3,
    lights: &[Light],
) -> Phong {
    let SurfacePoint { p, n, material } = *point;
    let v = -ray.direction.normalize();
    let mut terms = Phong {
        ambient: ambient(&material.matte, ambient_light),
        diffuse: DVec3::ZERO,
        specular: DVec3::ZERO,
    };
    for light in lights {
        let (l, d) = light.point_light.direction_from(p);
        terms.diffuse += diffuse(n, l, d, &material.matte, &light.point_light);
        if 0.0 < n.dot(l) {
            terms.specular += specular(reflect(n, l), v, d, material, light);
        }
    }
    terms
}
