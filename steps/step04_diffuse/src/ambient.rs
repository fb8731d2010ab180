use crate::Surface;
use glam::DVec3;

/// I_a = R_a L_a (slide "Ambient Term").
pub fn ambient(surface: &Surface, ambient_light: DVec3) -> DVec3 {
    surface.ambient * ambient_light
}
