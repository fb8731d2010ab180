use crate::Sphere;
use glam::DVec3;

/// n, the unit normal of `sphere` at a point `p` on it; it points out of the
/// sphere.
pub fn normal(sphere: &Sphere, p: DVec3) -> DVec3 {
    (p - sphere.centre) / sphere.radius
}
