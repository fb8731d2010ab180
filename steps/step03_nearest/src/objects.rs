use crate::{Object, Sphere};
use glam::DVec3;

/// The objects of the course's scene, each of its flat colour.
pub const OBJECTS: [Object<DVec3>; 9] = [
    object([-0.65, -0.16, -7.4], 1.2, [0.91, 0.34, 0.28]), // red, in the middle
    object([0.0, -41.2, -11.0], 40.0, [0.80, 0.76, 0.82]), // the ground
    object([0.45, -1.12, -5.8], 0.42, [0.99, 0.76, 0.32]), // golden, in front
    object([-3.0, -0.02, -10.2], 1.3, [0.44, 0.47, 0.78]), // blue, far away
    object([0.3, 0.4, 4.0], 1.2, [0.00, 1.00, 0.00]),      // green, behind the eye
    object([3.3, -0.69, -6.4], 0.9, [0.16, 0.60, 0.60]),   // teal, partly outside
    object([-2.05, -1.05, -6.1], 0.5, [0.97, 0.94, 0.90]), // white, in front
    object([1.55, 0.42, -10.8], 1.65, [0.96, 0.66, 0.56]), // salmon, far away
    object([-2.1, 2.3, -9.5], 0.34, [0.99, 0.87, 0.62]),   // cream, up in the air
];

const fn object(centre: [f64; 3], radius: f64, colour: [f64; 3]) -> Object<DVec3> {
    let sphere = Sphere { centre: DVec3::from_array(centre), radius };
    Object { sphere, material: DVec3::from_array(colour) }
}
