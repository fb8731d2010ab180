use crate::{Light, Material};
use glam::DVec3;

/// I_s = R_s / (a + bd + cd²) · max(r·v, 0)ⁿ · L_s (slide "Specular Term").
/// `r` is l reflected, `v` the way to the eye, both unit; the light is `d` away.
pub fn specular(
    r: DVec3,
    v: DVec3,
    d: f64,
    material: &Material,
    light: &Light,
) -> DVec3 {
    let cosine = r.dot(v);
    if cosine <= 0.0 {
        return DVec3::ZERO; // an even n would turn a cosine below 0 into light
    }
    material.specular / light.point_light.attenuation.divisor(d)
        * cosine.powi(material.shininess)
        * light.specular
}
