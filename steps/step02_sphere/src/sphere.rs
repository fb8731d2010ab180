use crate::{Ray, Roots, quadratic};
use glam::DVec3;

/// A sphere: all points at the same distance from its centre (slide "The Sphere").
/// ```
/// use {glam::DVec3, step02_sphere::{Ray, Sphere}};
/// let ray = Ray { start: DVec3::ZERO, direction: DVec3::X };
/// let sphere = Sphere::new([4.0, 0.0, 0.0], 1.0);
/// assert_eq!(sphere.coefficients(&ray), (1.0, -8.0, 15.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// (x₀, y₀, z₀), the centre.
    pub centre: DVec3,
    /// r, the distance from the centre to the surface; above 0.
    pub radius: f64,
}

impl Sphere {
    /// A sphere with this centre and this radius, which has to be above 0.
    pub const fn new(centre: [f64; 3], radius: f64) -> Self {
        Self { centre: DVec3::from_array(centre), radius }
    }

    /// The a, b and c of at² + bt + c = 0, for the t at which the line of `ray`
    /// meets the sphere. Let s lead from the centre to the start of the ray. Then
    /// s + tV leads from the centre to the point at t, which is on the sphere if
    /// |s + tV|² = radius². Multiplied out, that is at² + bt + c = 0.
    pub fn coefficients(&self, ray: &Ray) -> (f64, f64, f64) {
        let s = ray.start - self.centre;
        let v = ray.direction;
        let a = v.dot(v);
        let b = 2.0 * s.dot(v);
        let c = s.dot(s) - self.radius * self.radius;
        (a, b, c)
    }

    /// Every t at which the line of `ray` meets the sphere.
    pub fn intersect(&self, ray: &Ray) -> Roots {
        let (a, b, c) = self.coefficients(ray);
        quadratic(a, b, c)
    }
}
