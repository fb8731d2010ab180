use crate::Sphere;

/// A thing to see; `M` is a flat colour here, and something else in later steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<M> {
    /// Its name, which tells it from the others.
    pub name: &'static str,
    /// Its place and its size.
    pub sphere: Sphere,
    /// What it is made of.
    pub material: M,
}

impl<M> Object<M> {
    /// The same object made of something else.
    pub fn with_material<N>(self, material: N) -> Object<N> {
        Object { name: self.name, sphere: self.sphere, material }
    }
}
