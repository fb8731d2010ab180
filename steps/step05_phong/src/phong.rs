use crate::{
    Light, Material, Ray, SurfacePoint, ambient, diffuse, reflect, specular,
};
use glam::DVec3;
use std::ops::AddAssign;

/// The three terms of the light that goes from a point to the eye.
#[derive(Debug, Default)]
pub struct Terms {
    /// I_a, from the light that is the same everywhere.
    pub ambient: DVec3,
    /// I_d, scattered in all directions.
    pub diffuse: DVec3,
    /// I_s, mirrored.
    pub specular: DVec3,
}

impl Terms {
    /// I = I_a + I_d + I_s.
    pub fn sum(&self) -> DVec3 {
        self.ambient + self.diffuse + self.specular
    }
}

impl AddAssign for Terms {
    fn add_assign(&mut self, other: Self) {
        self.ambient += other.ambient;
        self.diffuse += other.diffuse;
        self.specular += other.specular;
    }
}

/// The terms of one light at a point `p` with the unit normal `n`. The unit vector
/// `v` points from `p` to the eye. I_a belongs to no light, so it is 0 here. A
/// light behind the surface gives nothing, not even a highlight. The slide has no
/// such rule.
pub fn light_terms(
    p: DVec3,
    n: DVec3,
    v: DVec3,
    material: &Material,
    light: &Light,
) -> Terms {
    let (l, d) = light.point_light.direction_from(p);
    let mut terms = Terms::default();
    // If the light is behind the surface, the diffuse term would be 0 anyway, but
    // the specular one could be above 0.
    if n.dot(l) > 0.0 {
        terms.diffuse = diffuse(n, l, d, &material.matte, &light.point_light);
        terms.specular = specular(reflect(n, l), v, d, material, light);
    }
    terms
}

/// The terms of the light that comes back along `ray` from `point` (slide "Phong
/// Lighting"): I_a once, and I_d and I_s of each light.
pub fn phong(
    point: &SurfacePoint<Material>,
    ray: &Ray,
    ambient_light: DVec3,
    lights: &[Light],
) -> Terms {
    let (p, n, material) = (point.p, point.n, point.material());
    let v = -ray.direction.normalize();
    let mut terms = Terms {
        ambient: ambient(&material.matte, ambient_light),
        ..Terms::default()
    };
    for light in lights {
        terms += light_terms(p, n, v, material, light);
    }
    terms
}
