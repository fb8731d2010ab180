use crate::{Object, Ray};

/// Where a ray first meets an object, and which object that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<'a, M> {
    /// t in r(t) = S + tV; above 0.
    pub t: f64,
    /// The object that was hit, borrowed from the list.
    pub object: &'a Object<M>,
}

/// The hit with the smallest t above 0, or None if `ray` misses all `objects`.
/// ```
/// use step03_nearest::{Camera, OBJECTS, nearest};
/// let ray = Camera::new(640, 360, 60_f64.to_radians()).ray(362.0, 286.0);
/// assert_eq!(nearest(&OBJECTS, &ray).unwrap().object.name, "golden sphere");
/// ```
pub fn nearest<'a, M>(objects: &'a [Object<M>], ray: &Ray) -> Option<Hit<'a, M>> {
    // The nearest hit so far, or None as long as there is none.
    let mut best: Option<Hit<M>> = None;
    for object in objects {
        // A hit is better if there is no best one yet, or if its t is smaller.
        if let Some(t) = object.sphere.intersect(ray).first_hit()
            && best.as_ref().is_none_or(|hit| t < hit.t)
        {
            best = Some(Hit { t, object });
        }
    }
    best
}
