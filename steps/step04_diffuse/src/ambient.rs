use glam::DVec3;

/// I_a = R_a L_a (slide "Ambient Term").
pub fn ambient(r_a: DVec3, l_a: DVec3) -> DVec3 {
    r_a * l_a
}
