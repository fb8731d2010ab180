use glam::DVec3;

/// A ray r(t) = S + tV: a starting point and a vector (slide "Rays").
/// ```
/// use glam::DVec3;
/// let ray = step01_rays::Ray { start: DVec3::X, direction: DVec3::NEG_Z };
/// assert_eq!(ray.at(2.0), DVec3::new(1.0, 0.0, -2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// S, the point where the ray starts.
    pub start: DVec3,
    /// V, its direction. It may have any length except 0, and is not normalised.
    pub direction: DVec3,
}

impl Ray {
    /// The point r(t) = S + tV. The unit of `t` is the length of V.
    pub fn at(&self, t: f64) -> DVec3 {
        self.start + t * self.direction
    }
}
