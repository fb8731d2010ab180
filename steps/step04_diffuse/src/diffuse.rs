use crate::PointLight;
use glam::DVec3;

/// The diffuse term I_d = R_d / (a + bd + cd²) · max(l·n, 0) · L_d (slide "Diffuse
/// Term").
///
/// `n` and `l` are unit vectors: the normal, and the way to the light, which is `d`
/// away.
pub fn diffuse(
    n: DVec3,
    l: DVec3,
    d: f64,
    r_d: DVec3,
    light: &PointLight,
) -> DVec3 {
    r_d / light.attenuation.at(d) * l.dot(n).max(0.0) * light.diffuse
}
