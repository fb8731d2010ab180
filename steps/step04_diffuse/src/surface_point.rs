use crate::{Object, Ray, Sphere, nearest};
use glam::DVec3;

/// A point on the surface of an object, with all that its light depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint<'a, M> {
    /// p, where it is.
    pub p: DVec3,
    /// n, the unit normal there.
    pub n: DVec3,
    /// What the object is made of.
    pub material: &'a M,
}

/// n, the unit normal of `sphere` at a point `p` on it; it points outwards.
pub fn normal(sphere: &Sphere, p: DVec3) -> DVec3 {
    (p - sphere.centre) / sphere.radius
}

/// The point at which `ray` meets the nearest object, None where it misses all.
pub fn visible_point<'a, M>(
    objects: &'a [Object<M>],
    ray: &Ray,
) -> Option<SurfacePoint<'a, M>> {
    let hit = nearest(objects, ray)?;
    let p = ray.at(hit.t);
    let n = normal(&hit.object.sphere, p);
    Some(SurfacePoint { p, n, material: &hit.object.material })
}
