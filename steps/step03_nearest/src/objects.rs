use crate::{Object, Sphere};
use glam::DVec3;

/// The objects of the scene: name, centre, radius and colour.
pub const OBJECTS: [Object<DVec3>; 9] = [
    object("red sphere", [-0.65, -0.16, -7.4], 1.2, [0.91, 0.34, 0.28]),
    object("ground", [0.0, -41.2, -11.0], 40.0, [0.80, 0.76, 0.82]),
    object("golden sphere", [0.45, -1.12, -5.8], 0.42, [0.99, 0.76, 0.32]),
    object("blue sphere", [-3.0, -0.02, -10.2], 1.3, [0.44, 0.47, 0.78]),
    object("green sphere", [0.3, 0.4, 4.0], 1.2, [0.00, 1.00, 0.00]),
    object("teal sphere", [3.3, -0.69, -6.4], 0.9, [0.16, 0.60, 0.60]),
    object("white sphere", [-2.05, -1.05, -6.1], 0.5, [0.97, 0.94, 0.90]),
    object("salmon sphere", [1.55, 0.42, -10.8], 1.65, [0.96, 0.66, 0.56]),
    object("cream sphere", [-2.1, 2.3, -9.5], 0.34, [0.99, 0.87, 0.62]),
];

const fn object(
    name: &'static str,
    centre: [f64; 3],
    radius: f64,
    colour: [f64; 3],
) -> Object<DVec3> {
    let sphere = Sphere::new(centre, radius);
    Object { name, sphere, material: DVec3::from_array(colour) }
}
