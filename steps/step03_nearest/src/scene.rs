use crate::Sphere;
use glam::DVec3;

/// The spheres of the scene that steps 3 to 5 share.
pub const SPHERES: [Sphere; 9] = [
    sphere(-0.65, -0.16, -7.4, 1.2), // the red one, in the middle
    sphere(0.0, -41.2, -11.0, 40.0), // the ground
    sphere(0.45, -1.12, -5.8, 0.42), // a small one, before the red one
    sphere(-3.0, -0.02, -10.2, 1.3), // far away on the left
    sphere(0.3, 0.4, 4.0, 1.2),      // behind the camera: never seen
    sphere(3.3, -0.69, -6.4, 0.9),   // partly outside the picture, on the right
    sphere(-2.05, -1.05, -6.1, 0.5), // in front on the left
    sphere(1.55, 0.42, -10.8, 1.65), // far away on the right
    sphere(-2.1, 2.3, -9.5, 0.34),   // up in the air
];

/// The flat colour of each sphere, in the order of [`SPHERES`].
pub const COLOURS: [DVec3; 9] = [
    DVec3::new(0.91, 0.34, 0.28),
    DVec3::new(0.80, 0.76, 0.82),
    DVec3::new(0.99, 0.76, 0.32),
    DVec3::new(0.44, 0.47, 0.78),
    DVec3::new(0.00, 1.00, 0.00),
    DVec3::new(0.16, 0.60, 0.60),
    DVec3::new(0.97, 0.94, 0.90),
    DVec3::new(0.96, 0.66, 0.56),
    DVec3::new(0.99, 0.87, 0.62),
];

const fn sphere(x: f64, y: f64, z: f64, radius: f64) -> Sphere {
    Sphere { centre: DVec3::new(x, y, z), radius }
}
