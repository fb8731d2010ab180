use crate::{Matte, PointLight};
use glam::DVec3;

/// I_d = R_d / (a + bd + cd²) · max(n·l, 0) · L_d (slide "Diffuse Term").
/// `n` points outwards, `l` to the light, which is `d` away; both are unit vectors.
pub fn diffuse(
    n: DVec3,
    l: DVec3,
    d: f64,
    material: &Matte,
    light: &PointLight,
) -> DVec3 {
    material.diffuse / light.attenuation.divisor(d)
        * n.dot(l).max(0.0)
        * light.diffuse
}
