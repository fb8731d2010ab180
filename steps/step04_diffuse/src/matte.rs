use glam::DVec3;

/// A matte material, by the light that it reflects: 0 to 1 for red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matte {
    /// R_a, the part of the ambient light that it reflects.
    pub ambient: DVec3,
    /// R_d, the part of the light that it scatters all around.
    pub diffuse: DVec3,
}

impl Matte {
    /// The material that has one colour in ambient and diffuse light.
    pub fn of(colour: DVec3) -> Self {
        Self { ambient: colour, diffuse: colour }
    }
}
