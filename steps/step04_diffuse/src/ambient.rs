use crate::Matte;
use glam::DVec3;

/// I_a = R_a L_a, the ambient light that comes back from the material, each channel
/// by itself (slide "Ambient Term").
pub fn ambient(material: &Matte, ambient_light: DVec3) -> DVec3 {
    material.ambient * ambient_light
}
