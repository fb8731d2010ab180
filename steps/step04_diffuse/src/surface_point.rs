use crate::{Hit, Object, Ray, Sphere, nearest};
use glam::DVec3;

/// A point of a surface, seen by a ray.
#[derive(Debug)]
pub struct SurfacePoint<'a, M> {
    /// The hit: its t, and the object.
    pub hit: Hit<'a, M>,
    /// p = r(t), where the point is.
    pub p: DVec3,
    /// n, the unit normal there.
    pub n: DVec3,
}

impl<'a, M> SurfacePoint<'a, M> {
    /// The material of the object.
    pub fn material(&self) -> &'a M {
        &self.hit.object.material
    }
}

/// n, the unit normal of `sphere` at a point `p` on it. It points outwards.
pub fn normal(sphere: &Sphere, p: DVec3) -> DVec3 {
    (p - sphere.centre) / sphere.radius
}

/// The point at which `ray` meets the nearest object, or None if it misses all.
pub fn visible_point<'a, M>(
    objects: &'a [Object<M>],
    ray: &Ray,
) -> Option<SurfacePoint<'a, M>> {
    let hit = nearest(objects, ray)?;
    let p = ray.at(hit.t);
    let n = normal(&hit.object.sphere, p);
    Some(SurfacePoint { hit, p, n })
}
