use step05_phong::{Light, Material, Object, Scene};

/// A material, and what its object is called.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Named {
    /// The name, with its article.
    pub name: &'static str,
    /// The material.
    pub material: Material,
}

/// The objects of the course's scene, in its order.
const NAMES: [&str; 9] = [
    "the red sphere",
    "the ground",
    "the golden sphere",
    "the blue sphere",
    "the green sphere",
    "the teal sphere",
    "the white sphere",
    "the salmon sphere",
    "the cream sphere",
];

/// The scene of step 5, and the names of its objects.
pub fn scene() -> Scene<Named, Light> {
    let Scene { objects, ambient_light, lights } = step05_phong::scene();
    let named = |(Object { sphere, material }, name)| Object {
        sphere,
        material: Named { name, material },
    };
    let objects = objects.into_iter().zip(NAMES).map(named).collect();
    Scene { objects, ambient_light, lights }
}
