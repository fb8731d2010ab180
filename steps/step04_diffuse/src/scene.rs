use crate::{Attenuation, Matte, OBJECTS, Object, PointLight};
use glam::DVec3;

/// Objects, and the light to see them in.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<M, L> {
    /// The objects, whose materials have the type `M`.
    pub objects: Vec<Object<M>>,
    /// L_a, the ambient light, the same everywhere.
    pub ambient_light: DVec3,
    /// The lamps, which have the type `L`.
    pub lights: Vec<L>,
}

/// L_a of this scene, a little blue.
pub const AMBIENT_LIGHT: DVec3 = DVec3::new(0.32, 0.32, 0.42);

/// The warm light, up on the left, in front of the objects.
pub const WARM_LIGHT: PointLight = PointLight {
    position: DVec3::new(-4.0, 5.0, -2.0),
    diffuse: DVec3::new(1.0, 0.84, 0.64),
    attenuation: Attenuation { a: 0.7, b: 0.02, c: 0.005 },
};

/// The cool light, on the right, behind the objects.
pub const COOL_LIGHT: PointLight = PointLight {
    position: DVec3::new(5.5, 2.2, -11.5),
    diffuse: DVec3::new(0.45, 0.6, 1.0),
    attenuation: Attenuation { a: 0.5, b: 0.0, c: 0.02 },
};

/// The objects of step 3, each in a matte material of its colour, and two lamps.
pub fn scene() -> Scene<Matte, PointLight> {
    let matte = |object: Object<DVec3>| {
        let material = Matte::of(object.material);
        object.with_material(material)
    };
    Scene {
        objects: OBJECTS.map(matte).to_vec(),
        ambient_light: AMBIENT_LIGHT,
        lights: vec![WARM_LIGHT, COOL_LIGHT],
    }
}
