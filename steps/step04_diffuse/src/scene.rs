use crate::{Attenuation, PointLight};
use glam::DVec3;

/// L_a, the ambient light, the same everywhere.
pub const AMBIENT_LIGHT: DVec3 = DVec3::new(0.32, 0.32, 0.42);

/// The point lights.
pub const LIGHTS: [PointLight; 2] = [
    // The warm one, up on the left before the scene.
    PointLight {
        position: DVec3::new(-4.0, 5.0, -2.0),
        diffuse: DVec3::new(1.0, 0.84, 0.64),
        attenuation: Attenuation { a: 0.7, b: 0.02, c: 0.005 },
    },
    // The cool one, behind the scene on the right.
    PointLight {
        position: DVec3::new(5.5, 2.2, -11.5),
        diffuse: DVec3::new(0.45, 0.6, 1.0),
        attenuation: Attenuation { a: 0.5, b: 0.0, c: 0.02 },
    },
];
