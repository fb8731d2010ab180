use crate::Sphere;

/// A thing to see; `M` is a flat colour here, and something else in later steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<M> {
    /// Its place and its size.
    pub sphere: Sphere,
    /// What it is made of.
    pub material: M,
}
