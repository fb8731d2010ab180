use crate::Matte;
use glam::DVec3;

/// A shiny material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// R_a and R_d.
    pub matte: Matte,
    /// R_s, the part of a lamp's light that the material mirrors: red, green and
    /// blue, each 0 to 1.
    pub specular: DVec3,
    /// The shininess, above 0. The slide calls it n, like the normal. The larger it
    /// is, the smaller the highlight.
    pub shininess: i32,
}
