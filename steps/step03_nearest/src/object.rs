use crate::Sphere;

/// An object to be seen. Its material `M` is a flat colour here, and more later on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<M> {
    /// Its name, for messages and tests. Several objects may have the same one.
    pub name: &'static str,
    /// Where it is, and how large.
    pub sphere: Sphere,
    /// What it is made of.
    pub material: M,
}

impl<M> Object<M> {
    /// The same object in another material.
    pub fn with_material<N>(self, material: N) -> Object<N> {
        Object { name: self.name, sphere: self.sphere, material }
    }
}
