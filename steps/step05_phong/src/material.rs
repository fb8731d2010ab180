use crate::Matte;
use glam::DVec3;

/// A material that shines, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// R_a and R_d.
    pub matte: Matte,
    /// R_s, the part of the light that it mirrors; 0 to 1 for red, green and blue.
    pub specular: DVec3,
    /// n, the shininess: the larger it is, the smaller the highlight; above 0.
    pub shininess: i32,
}
