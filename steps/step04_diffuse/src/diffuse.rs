use crate::{Matte, PointLight};
use glam::DVec3;

/// I_d = R_d / (a + bd + cd²) · max(n·l, 0) · L_d (slide "Diffuse Term"). `n` and
/// `l` are unit vectors: `n` points outwards, and `l` to the light, which is `d`
/// away.
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

/// I_d of one light at a point `p` with the unit normal `n`.
pub fn diffuse_at(
    p: DVec3,
    n: DVec3,
    material: &Matte,
    light: &PointLight,
) -> DVec3 {
    let (l, d) = light.direction_from(p);
    diffuse(n, l, d, material, light)
}
