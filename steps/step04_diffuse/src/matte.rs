use glam::DVec3;

/// A matte material: how much light it reflects, from 0 to 1 in red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matte {
    /// R_a, the part of the ambient light that it reflects.
    pub ambient: DVec3,
    /// R_d, the part of a lamp's light that it scatters in all directions.
    pub diffuse: DVec3,
}

impl Matte {
    /// The material that has the same colour in ambient and in diffuse light.
    pub fn of(colour: DVec3) -> Self {
        Self { ambient: colour, diffuse: colour }
    }
}
