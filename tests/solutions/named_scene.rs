//! Tests of the scenes that are made from students' names.

use course::generate_scene;
use std::collections::HashSet;
use support::primary_rays;

#[test]
fn spheres_of_a_named_scene_do_not_overlap_and_no_ray_is_tangent_to_a_sphere() {
    for name in ["ada", "bob", ""] {
        let objects = generate_scene(name).objects;
        // Allow a small overlap: as in the course's scene, the numbers are rounded to two decimals,
        // so a sphere that rests on the ground may overlap the ground a little.
        for (k, a) in objects.iter().enumerate() {
            for b in &objects[..k] {
                let distance = a.sphere.centre.distance(b.sphere.centre);
                let radii = a.sphere.radius + b.sphere.radius;
                assert!(distance - radii > -0.01, "{name}: {}, {}", a.name, b.name);
            }
        }
        for ray in primary_rays() {
            for object in &objects {
                let (a, b, c) = object.sphere.coefficients(&ray);
                let margin = (b * b - 4.0 * a * c).abs() / (b * b + 4.0 * a * c.abs());
                assert!(margin > 1e-12, "{name}: {}, {ray:?}", object.name);
            }
        }
    }
}

#[test]
fn each_name_has_its_own_scene() {
    let scene_text = |name: &str| format!("{:?}", generate_scene(name));
    let names = (0..1000).map(|k| format!("student {k}"));
    let scenes: HashSet<_> = names.map(|name| scene_text(&name)).collect();
    assert_eq!(scenes.len(), 1000);
    assert_eq!(scene_text("student 7"), scene_text(" student  7\n"));
}
