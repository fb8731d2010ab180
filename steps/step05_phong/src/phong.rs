use crate::{Light, Material, Surface, ambient, diffuse, reflect, specular};
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

/// The light that the point `p`, with unit normal `n`, sends along the unit vector
/// `v` to the eye (slide "Phong Lighting").
///
/// A light behind the surface gives no highlight, whatever r·v is.
pub fn phong(
    p: DVec3,
    n: DVec3,
    v: DVec3,
    material: &Material,
    l_a: DVec3,
    lights: &[Light],
) -> Phong {
    let Surface { ambient: r_a, diffuse: r_d } = material.surface;
    let mut sum = Phong {
        ambient: ambient(r_a, l_a),
        diffuse: DVec3::ZERO,
        specular: DVec3::ZERO,
    };
    for light in lights {
        let (l, d) = light.point.seen_from(p);
        sum.diffuse += diffuse(n, l, d, r_d, &light.point);
        if 0.0 < n.dot(l) {
            sum.specular += specular(reflect(l, n), v, d, material, light);
        }
    }
    sum
}
