use glam::DVec3;

/// A matte material: what it reflects of red, green and blue light, each 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matte {
    /// R_a, the part of the ambient light that the material reflects.
    pub ambient: DVec3,
    /// R_d, the part of a lamp's light that the material scatters in all
    /// directions.
    pub diffuse: DVec3,
}

impl Matte {
    /// A material that has the same colour in ambient and in diffuse light.
    pub fn of(colour: DVec3) -> Self {
        Self { ambient: colour, diffuse: colour }
    }
}
