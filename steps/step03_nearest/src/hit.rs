use crate::{Ray, Sphere};

/// Where a ray first meets an object, and which object it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// t in r(t) = S + tV; above 0.
    pub t: f64,
    /// The place of the object in its list, from 0.
    pub index: usize,
}

/// The hit with the smallest t above 0 among all `spheres`, or None where `ray`
/// misses them all.
pub fn nearest(spheres: &[Sphere], ray: &Ray) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (index, sphere) in spheres.iter().enumerate() {
        if let Some(t) = sphere.intersect(ray).first_hit()
            && nearest.is_none_or(|hit| t < hit.t)
        {
            nearest = Some(Hit { t, index });
        }
    }
    nearest
}
