use crate::{Light, Material};
use glam::DVec3;

/// I_s = R_s / (a + bd + cd²) · max(r·v, 0)ⁿ · L_s (slide "Specular Term").
///
/// `r` and `v` are unit vectors, l reflected and to the eye; the light is `d` away.
/// Without the max, an even n would make a highlight of a cosine below 0.
pub fn specular(
    r: DVec3,
    v: DVec3,
    d: f64,
    material: &Material,
    light: &Light,
) -> DVec3 {
    material.specular / light.point_light.attenuation.at(d)
        * r.dot(v).max(0.0).powi(material.shininess)
        * light.specular
}
