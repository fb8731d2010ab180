//! Walks along a ray in steps, and tests each point with the equation of a sphere.

use glam::DVec3;
use step01_rays::Ray;

fn main() {
    let centre = DVec3::new(0.0, 0.0, -5.0);
    let radius = 1.0;
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
    for step in 0..=10 {
        let t = 0.7 * f64::from(step);
        let from_centre = ray.at(t) - centre;
        let is_inside = from_centre.length_squared() < radius * radius;
        println!("t = {t:.1}: {}", if is_inside { "inside" } else { "outside" });
    }
}
