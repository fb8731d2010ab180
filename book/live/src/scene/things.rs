//! What is in the scene at first, and what waits to be.

use glam::DVec3;
use step05_phong::{Attenuation, COOL, Light, PointLight, WARM};

/// Name, 1 if it is in the scene, centre, radius, colour, R_s and n of a sphere.
pub type Ball = (&'static str, f64, [f64; 3], f64, [f64; 3], f64, f64);

/// The nine of the course, and three that are left out at first.
#[rustfmt::skip]
pub const BALLS: [Ball; 12] = [
    ("red sphere", 1.0, [-0.65, -0.16, -7.4], 1.2, [0.91, 0.34, 0.28], 0.7, 40.0),
    ("ground", 1.0, [0.0, -41.2, -11.0], 40.0, [0.80, 0.76, 0.82], 0.15, 10.0),
    ("golden sphere", 1.0, [0.45, -1.12, -5.8], 0.42, [0.99, 0.76, 0.32], 0.8, 150.0),
    ("blue sphere", 1.0, [-3.0, -0.02, -10.2], 1.3, [0.44, 0.47, 0.78], 0.4, 30.0),
    ("green sphere", 1.0, [0.3, 0.4, 4.0], 1.2, [0.00, 1.00, 0.00], 0.5, 30.0),
    ("teal sphere", 1.0, [3.3, -0.69, -6.4], 0.9, [0.16, 0.60, 0.60], 0.6, 16.0),
    ("white sphere", 1.0, [-2.05, -1.05, -6.1], 0.5, [0.97, 0.94, 0.90], 0.9, 300.0),
    ("salmon sphere", 1.0, [1.55, 0.42, -10.8], 1.65, [0.96, 0.66, 0.56], 0.5, 40.0),
    ("cream sphere", 1.0, [-2.1, 2.3, -9.5], 0.34, [0.99, 0.87, 0.62], 0.4, 20.0),
    ("tenth sphere", 0.0, [1.25, -1.1, -5.0], 0.35, [0.45, 0.20, 0.60], 0.8, 80.0),
    ("eleventh sphere", 0.0, [-1.2, 1.6, -7.0], 0.4, [0.10, 0.30, 0.75], 0.6, 60.0),
    ("twelfth sphere", 0.0, [1.6, 1.7, -8.0], 0.45, [0.85, 0.15, 0.35], 0.3, 20.0),
];

/// Name of a light, 1 if it is on, and what it is.
pub type Lamp = (&'static str, f64, Light);

/// The two of the course, and one that is off at first.
pub const LAMPS: [Lamp; 3] = [
    (
        "warm light",
        1.0,
        Light { point_light: WARM, specular: DVec3::new(1.0, 0.9, 0.8) },
    ),
    (
        "cool light",
        1.0,
        Light { point_light: COOL, specular: DVec3::new(0.5, 0.7, 1.0) },
    ),
    (
        "third light",
        0.0,
        Light { point_light: ROSE, specular: DVec3::new(1.0, 0.6, 0.8) },
    ),
];

/// A light among the spheres.
const ROSE: PointLight = PointLight {
    position: DVec3::new(0.3, 1.5, -5.0),
    diffuse: DVec3::new(0.9, 0.3, 0.6),
    attenuation: Attenuation { a: 0.6, b: 0.0, c: 0.1 },
};
