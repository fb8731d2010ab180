use crate::Sphere;

/// A thing to see. Its material `M` is a flat colour here, and more in later steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<M> {
    /// What we call it when we speak of it. Several objects may have the same name.
    pub name: &'static str,
    /// Its shape: where it is, and how large.
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
