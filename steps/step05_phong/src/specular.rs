use crate::{Light, Material};
use glam::DVec3;

/// The specular term I_s = R_s / (a + bd + cd²) · max(r·v, 0)ⁿ · L_s (slide
/// "Specular Term").
///
/// `r` and `v` are unit vectors: the mirrored way to the light, which is `d` away,
/// and the way to the eye.
pub fn specular(
    r: DVec3,
    v: DVec3,
    d: f64,
    material: &Material,
    light: &Light,
) -> DVec3 {
    let cosine = r.dot(v).max(0.0);
    if cosine == 0.0 {
        return DVec3::ZERO; // as at many points: spare them the power
    }
    material.specular / light.point.attenuation.at(d)
        * cosine.powi(material.shininess)
        * light.specular
}
