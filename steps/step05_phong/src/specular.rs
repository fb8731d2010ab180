use crate::{Light, Material};
use glam::DVec3;

/// I_s = R_s / (a + bd + cd²) · max(r·v, 0)ⁿ · L_s (slide "Specular Term").
/// `r` is `l` reflected, and `v` points to the eye. Both are unit vectors. The light is
/// `d` away.
pub fn specular(
    r: DVec3,
    v: DVec3,
    d: f64,
    material: &Material,
    light: &Light,
) -> DVec3 {
    material.specular / light.point_light.attenuation.divisor(d)
        * r.dot(v).max(0.0).powi(material.shininess)
        * light.specular
}
