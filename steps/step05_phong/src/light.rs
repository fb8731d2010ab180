use crate::PointLight;
use glam::DVec3;

/// A point light whose highlights may have a colour of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Its position, L_d and attenuation.
    pub point_light: PointLight,
    /// L_s, its intensity in highlights: red, green and blue, each at least 0.
    pub specular: DVec3,
}
