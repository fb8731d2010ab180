use crate::{Light, Material};
use glam::DVec3;

/// I_s = R_s / (a + bd + cd²) · max(r·v, 0)ⁿ · L_s (slide "Specular Term"). `r` is
/// the direction to the light, reflected, and `v` is the direction to the eye; both
/// are unit vectors. The light is `d` away. The exponent n is the shininess.
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
