//! Step 3: a tie for the nearest hit. No worked example or picture in the book has such a tie.

use glam::DVec3;
use step03_nearest::{Object, Ray, Sphere, nearest};

#[test]
fn first_of_two_equally_near_objects_wins() {
    let sphere = Sphere::new([0.0, 0.0, -5.0], 1.0);
    let objects = ["first", "second"].map(|name| Object { name, sphere, material: () });
    let ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
    assert_eq!(nearest(&objects, &ray).map(|hit| hit.object.name), Some("first"));
}
