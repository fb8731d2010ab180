use crate::Matte;
use glam::DVec3;

/// A material that shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// R_a and R_d.
    pub matte: Matte,
    /// R_s, the part of a lamp's light that it mirrors: 0 to 1 in red, green and blue.
    pub specular: DVec3,
    /// n, the shininess, above 0. The larger it is, the smaller the highlight.
    pub shininess: i32,
}
