use crate::{Light, Material, Point, Ray, ambient, diffuse, reflect, specular};
use glam::DVec3;

/// The three terms of the light that leaves a point, each summed over all lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// I_a, the same from everywhere.
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
///
/// A light behind the surface gives no highlight.
pub fn phong(
    ray: &Ray,
    point: &Point<Material>,
    ambient_light: DVec3,
    lights: &[Light],
) -> Phong {
    let Point { p, n, material } = *point;
    let v = -ray.direction.normalize();
    let mut sum = Phong {
        ambient: ambient(material.surface.ambient, ambient_light),
        diffuse: DVec3::ZERO,
        specular: DVec3::ZERO,
    };
    for light in lights {
        let (l, d) = light.point.seen_from(p);
        sum.diffuse += diffuse(n, l, d, &material.surface, &light.point);
        if 0.0 < n.dot(l) {
            sum.specular += specular(reflect(l, n), v, d, material, light);
        }
    }
    sum
}
