use crate::{PointLight, Surface};
use glam::DVec3;

/// I_d = R_d / (a + bd + cd²) · max(n·l, 0) · L_d (slide "Diffuse Term").
/// `n` and `l` are unit vectors, to the outside and to the light; that is `d` away.
pub fn diffuse(
    n: DVec3,
    l: DVec3,
    d: f64,
    surface: &Surface,
    light: &PointLight,
) -> DVec3 {
    surface.diffuse / light.attenuation.at(d) * n.dot(l).max(0.0) * light.diffuse
}
