use glam::DVec3;

/// How light fades with the distance d: it is divided by a + bd + cd².
/// ```
/// let attenuation = step04_diffuse::Attenuation { a: 1.0, b: 0.0, c: 0.25 };
/// assert_eq!(attenuation.divisor(2.0), 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation {
    /// The part that is the same at any distance.
    pub a: f64,
    /// The coefficient of d.
    pub b: f64,
    /// The coefficient of d².
    pub c: f64,
}

impl Attenuation {
    /// a + bd + cd², by which light is divided at the distance `d`. The result has
    /// to be above 0.
    pub fn divisor(&self, d: f64) -> f64 {
        self.a + self.b * d + self.c * d * d
    }
}

/// A light that shines from one point in all directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is.
    pub position: DVec3,
    /// L_d, its intensity in red, green and blue, each at least 0.
    pub diffuse: DVec3,
    /// How it fades: a, b and c, chosen by eye.
    pub attenuation: Attenuation,
}

impl PointLight {
    /// The unit vector l from the point `p` to the light, and the distance d.
    /// If `p` is the light itself, there is no direction; glam then gives d = 0 and
    /// l = (1, 0, 0).
    pub fn direction_from(&self, p: DVec3) -> (DVec3, f64) {
        (self.position - p).normalize_and_length()
    }
}
